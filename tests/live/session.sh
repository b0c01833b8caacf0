# What the live tests' scripts share; sourced. BIN: folder of the programs. WORK: scratch folder, where the short log is.
# Everything runs in a network namespace of its own, which takes its processes' messages with it when it ends.
set -u
export LCM_DEFAULT_URL=${LCM_DEFAULT_URL:-udpm://239.255.76.67:7667?ttl=0}
export CLICOLOR_FORCE=0

one_machine() {
  ip link set lo up && ip route add 224.0.0.0/4 dev lo
}

begin() {  # PROCESS [OPTION...]: starts scanway-PROCESS
  local name=$1
  shift
  "$BIN/scanway-$name" --state "$WORK/state-$name" "$@" 2>>"$WORK/$name.err" &
  eval "pid_$name=$!"
  for _ in $(seq 600); do
    [ "$(grep -c 'ready' "$WORK/$name.err")" -gt "$(eval "echo \${ready_$name:-0}")" ] && break
    sleep 0.1
  done
  eval "ready_$name=$(grep -c 'ready' "$WORK/$name.err")"
}

observe() {  # VERSION SECONDS: what is on the bus once that version is complete, into observed.txt
  "$BIN/scanway-live-tool" observe "$LCM_DEFAULT_URL" "$1" "$2" >"$WORK/observed.txt" 2>"$WORK/observer.err" &
  pid_observer=$!
  sleep 0.5
}

finish() {  # waits for the observer, ends the processes; status: 0 if all ended well
  local status=0
  wait "$pid_observer" || status=1
  for pid in ${pid_mapper:-} ${pid_planner:-}; do
    kill -TERM "$pid"
    wait "$pid" || status=1
  done
  return $status
}

# lcm-logger takes 30 messages at once and drops the rest when it is not let run: on a busy machine it goes first.
record() {  # FILE: all that is on the bus, until end_record
  local first='' url=$LCM_DEFAULT_URL
  chrt -f 10 true 2>/dev/null && first='chrt -f 10'
  $first lcm-logger -q --lcm-url="$url&recv_buf_size=4194304" "$1" 2>>"$WORK/logger.err" &
  pid_logger=$!
  sleep 1
}

end_record() {
  kill -INT "$pid_logger"
  wait "$pid_logger"
}
