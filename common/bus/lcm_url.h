#pragma once

#include <cstddef>
#include <string>

namespace scanway {

/// The URL in force: `chosen`, or else LCM_DEFAULT_URL, or else LCM's default (multicast that stays on this machine).
std::string lcm_url(const std::string& chosen);

/// What can be known before LCM starts, as LCM's own messages do not say it: throws InputError with one line that says
/// what is wrong and what to do, for a URL that LCM does not know, no route for multicast, no server for tcpq.
void check_lcm_url(const std::string& url);

/// `url` with a receive buffer of `bytes`, if it is one of multicast and does not ask for another size.
std::string with_receive_buffer(const std::string& url, std::size_t bytes);

/// What to do about a receive buffer of `granted` bytes, in one line; empty: nothing.
std::string receive_buffer_advice(const std::string& url, std::size_t granted);

/// What the kernel gives a socket that asks for a receive buffer of `bytes`.
std::size_t granted_receive_buffer(std::size_t bytes);

}  // namespace scanway
