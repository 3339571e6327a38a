#!/bin/sh
# A throw-away Slurm cluster of two nodes on this host: cluster.sh up|down FOLDER. Exit code 77, with the reason, where it
# cannot start. The commands of Slurm find it by SLURM_CONF=FOLDER/slurm.conf.
set -eu

action=$1
folder=$2
host=$(hostname -s)

skip() {
  echo "skipped: $*"
  exit 77
}

start_munge() {
  munge -n >/dev/null 2>&1 && return
  [ -s /etc/munge/munge.key ] || skip "munge has no key"
  install -d -o munge -g munge -m 755 /run/munge
  runuser -u munge -- "$(command -v munged)" || skip "munged does not start"
  sleep 1
}

write_configuration() {
  cat >"$folder/slurm.conf" <<END
ClusterName=signorini-test
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=27817
AuthType=auth/munge
SlurmUser=root
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool-%n
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd-%n.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_interval=1,bf_interval=1,requeue_delay=1
AccountingStorageType=accounting_storage/none
MpiDefault=none
ReturnToService=2
SlurmdTimeout=30
KillWait=2
CompleteWait=0
NodeName=n[1-2] NodeHostname=$host NodeAddr=127.0.0.1 Port=[27821-27822] CPUs=1 RealMemory=1000 State=UNKNOWN
PartitionName=test Nodes=n[1-2] Default=YES MaxTime=00:30:00 State=UP
END
}

up() {
  for tool in slurmctld slurmd munged sbatch; do
    command -v "$tool" >/dev/null || skip "$tool is not installed"
  done
  [ "$(id -u)" -eq 0 ] || skip "Slurm's daemons need root"
  mkdir -p "$folder/state" "$folder/spool-n1" "$folder/spool-n2"
  start_munge
  write_configuration
  slurmctld -c -f "$folder/slurm.conf" || skip "slurmctld does not start"
  for node in n1 n2; do slurmd -N "$node" -f "$folder/slurm.conf" || skip "slurmd does not start"; done
  i=0
  while [ "$(SLURM_CONF=$folder/slurm.conf sinfo -h -N -t idle 2>/dev/null | wc -l)" -ne 2 ]; do
    i=$((i + 1))
    [ "$i" -lt 60 ] || skip "the nodes do not come up; see $folder/slurmctld.log"
    sleep 0.5
  done
}

down() { # and gone: the next cluster needs their ports
  for file in "$folder"/*.pid; do
    [ -s "$file" ] || continue
    pid=$(cat "$file")
    kill "$pid" 2>/dev/null || continue
    i=0
    while kill -0 "$pid" 2>/dev/null && [ "$i" -lt 20 ]; do
      i=$((i + 1))
      sleep 0.5
    done
    kill -9 "$pid" 2>/dev/null || true
  done
}

case $action in
  up) up ;;
  down) down ;;
esac
