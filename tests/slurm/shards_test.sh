#!/bin/sh
# shards_test.sh SIGNORINI FOLDER: two shards as a Slurm job array, one of whose nodes is lost on the way, give the same
# accuracy as a local run. Exit code 77 where no Slurm can be had.
set -eu

program=$1
folder=$2
here=$(dirname -- "$0")
scenes='sdof-stop:sdof-far-stop:chain2-stop:chain3-stop'
methods='hat-lcp[samples=512|1024]:penalty-hbm[harmonics=10]'

. "$here/in_cluster.sh"

fail() {
  echo "failed: $*" >&2
  squeue -a >&2 || true
  cat "$folder"/run/log-*.txt >&2 || true
  exit 1
}

# wait_until TRIES COMMAND...: half a second between tries.
wait_until() {
  tries=$1
  shift
  until "$@"; do
    tries=$((tries - 1))
    [ "$tries" -gt 0 ] || fail "waited in vain for: $*"
    sleep 0.5
  done
}

first_record() { [ -s "$folder/run/shard-1/records.jsonl" ] || [ -s "$folder/run/shard-1/unfinished.jsonl" ]; }
node_of_shard_1() { squeue -h -r -t R -o '%K %N' | sed -n 's/^1 //p'; }
# lose NODE: nothing on it says another word, neither its daemons nor the run of shard 1.
lose() {
  kill -9 "$(cat "$folder/cluster/slurmd-$1.pid")"
  rm "$folder/cluster/slurmd-$1.pid"
  job=$(squeue -h -r -t R -o '%A %K' | sed -n 's/ 1$//p')
  for pattern in "slurmstepd: \\[$job\\." "$folder/cluster/spool-$1/" "--out $folder/run/shard-1"; do
    pkill -9 -f -- "$pattern" || true # gone already
  done
  scontrol update nodename="$1" state=down reason=lost
}
# A task that is requeued waits for two minutes unless it is told otherwise.
requeued() {
  task=$(squeue -h -r -t PD -o '%A %K %j' | sed -n 's/^\([0-9]*\) 1 signorini$/\1/p')
  [ -n "$task" ] && scontrol update jobid="$task" starttime=now
}
requeued_or_over() { requeued || all_over; } # the shard may have ended in that very moment
all_over() { [ -z "$(squeue -h)" ]; }

"$program" run catalogue --scenes "$scenes" --methods "$methods" --out "$folder/local" >/dev/null

"$program" submit slurm "$folder/run" --shards 2 catalogue --scenes "$scenes" --methods "$methods"
wait_until 240 first_record

# The node of shard 1 is lost; its task goes back to the queue and resumes on the other one.
node=$(node_of_shard_1)
if [ -n "$node" ]; then
  lose "$node"
  wait_until 60 requeued_or_over
  echo "node $node was lost"
else
  echo 'shard 1 was over before its node could be lost'
fi
wait_until 600 all_over
[ -f "$folder/run/merged/table.csv" ] || fail 'nothing was merged'

# Columns: case, status, errors, physics; the local table's rows are in the same order.
accuracy() { cut -d, -f1,8-21 "$1"; }
columns=$(head -n 1 "$folder/local/table.csv" | cut -d, -f8-21)
[ "$columns" = "status,period,x_l2,x_max,u_l2,velocity_l2,impulse,force_l2,x_l2_scene,error_bar,penetration,complementarity,energy_defect,contact_ratio" ] ||
  fail "other columns than expected: $columns"
accuracy "$folder/local/table.csv" >"$folder/local.csv"
accuracy "$folder/run/merged/table.csv" >"$folder/merged.csv"
cmp "$folder/local.csv" "$folder/merged.csv" || fail 'accuracy differs from the local run'
[ "$(wc -l <"$folder/merged.csv")" -eq 13 ] || fail 'not every case has its row'
"$program" status "$folder/run/merged" | grep -q 'done' || fail 'the merged run is not complete'
echo 'accuracy equals that of the local run'
