# A simulated robot on one pretend machine; sourced after session.sh. Its pan is four times as fast as a survey's.
ROBOT=$WORK/robot.yaml
begin_robot() {  # [OPTION...]: scanway-simulator with these options, and the bridges on its devices
  local ends=$WORK/ends name
  mkdir -p "$ends"
  "$BIN/scanway-simulator" --robot "$ROBOT" --can "unix:$ends/can" --tracker "$ends/tracker" --base "$ends/base" "$@" \
    >"$WORK/simulator.out" 2>"$WORK/simulator.err" </dev/null & pids_robot=$!
  until grep -q stands "$WORK/simulator.out"; do kill -0 "$pids_robot" || return 1; sleep 0.1; done
  "$BIN/scanway-sick" --robot "$ROBOT" --host 127.0.0.1 --no-laser-scan 2>"$WORK/sick.err" & pids_robot+=" $!"
  "$BIN/scanway-schunk" --robot "$ROBOT" --can "unix:$ends/can" 2>"$WORK/schunk.err" & pids_robot+=" $!"
  "$BIN/scanway-xsens" --robot "$ROBOT" --port "$ends/tracker" 2>"$WORK/xsens.err" & pids_robot+=" $!"
  "$BIN/scanway-base" --robot "$ROBOT" --port "$ends/base" 2>"$WORK/base.err" & pids_robot+=" $!"
  for name in LASER_LINE PAN_TILT_STATE IMU; do
    "$BIN/scanway" spy "$name" --once --seconds 20 >/dev/null 2>&1 || return 1
  done
}

end_robot() {  # status: 0 if all ended well
  local status=0 pid
  for pid in $pids_robot; do kill -TERM "$pid"; done
  for pid in $pids_robot; do wait "$pid" || status=1; done
  return $status
}

take_sweep() {  # until one is in the map; on a busy machine a device may be late to answer, and the sweep is given up
  for _ in 1 2 3 4 5; do
    "$BIN/scanway" command sweep --registered >>"$WORK/sweep.txt" 2>&1 && return
    sleep 3
  done
  return 1
}
