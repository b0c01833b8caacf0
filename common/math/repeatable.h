#pragma once

/// Elementary functions whose bits are the same on every CPU.
///
/// The C library picks among several versions of sin, cos, atan2, exp and log by what the CPU can do (with or without
/// fused multiply-add), and these differ in the last bit. A core's result must not depend on that, so it calls these.
/// Square roots, floor and the four operations are exact by IEEE 754 and need no version of their own.
/// Error: below 2 units in the last place (sin, cos: for |x| < 1e5 rad; relative to the nearest multiple of pi/2
/// below 1e-15 absolute).
namespace scanway::repeatable {

double sin(double x);
double cos(double x);
/// Angle of (x, y), radians in [-pi, pi]; atan2(0, 0) is 0.
double atan2(double y, double x);
double exp(double x);
/// Natural logarithm; -infinity at 0, NaN below.
double log(double x);

constexpr double kPi = 3.14159265358979323846;

}  // namespace scanway::repeatable
