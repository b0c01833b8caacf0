#!/bin/sh
# Evidence for fit_verdict.py: FOLDER/real.csv, train_*.csv and test_*.csv, a file a world and seed; what is there stays.
#   collect_evidence.sh build/bin/registration_evidence ../shared/data FOLDER FIRST_SEED LAST_SEED
# A seed takes some 4 CPU minutes for about 500 pairs. Two at a time: other seeds, the same folder.
set -e
program=$1 data=$2 folder=$3 first=$4 last=$5
train="yard hall street rubble corridor"
test="car_park trench slope ramp kerbs flat field"
mkdir -p "$folder"

# collect NAME ARGUMENTS: whole or not at all
collect() {
  name=$1
  shift
  [ -e "$folder/$name.csv" ] && return
  "$program" "$@" --mode both > "$folder/$name.part"
  mv "$folder/$name.part" "$folder/$name.csv"
}

across() {
  name=$1 seed=$2
  shift 2
  for world in "$@"; do set -- "$@" --world "$world"; shift; done
  collect "${name}_across.$seed" "$@" --first-seed "$seed" --sweeps 3 --max 0 --across 70
}

for seed in $(seq "$first" "$last"); do
  for world in $train; do collect "train_$world.$seed" --world "$world" --first-seed "$seed" --sweeps 9; done
  for world in $test; do collect "test_$world.$seed" --world "$world" --first-seed "$seed" --sweeps 9; done
  across train "$seed" yard hall street rubble
  across test "$seed" car_park trench slope ramp kerbs flat
  collect real --data "$data" --across 60
done
