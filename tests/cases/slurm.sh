#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# The job scripts of contrib/cluster on a real Slurm: munged, slurmctld and
# slurmd are started on loopback, with everything they write in a temporary
# folder. An array of three chunks, of which one is requeued in its middle and
# one is told that its time is up, and a job that merges afterwards, give the
# results of a single process; so does an MPI job that is requeued. One in which
# two ranks compute each realisation has the same outcomes, and a single run on
# two ranks goes on when it is requeued.
#
# usage: slurm.sh WAKER_BINARY SOURCE_DIR
set -u
shopt -s nullglob

for program in munged slurmctld slurmd sbatch; do
  if ! PATH=$PATH:/usr/sbin:/sbin command -v $program > /dev/null; then
    echo "FAILED: $program is not installed: Debian packages slurm-wlm, munge" >&2
    exit 1
  fi
done

export PATH=$PATH:/usr/sbin:/sbin
WAKER=$(realpath "$1")
export WAKER
source=$(realpath "$2")
scripts=$source/contrib/cluster
file=$source/parameters/chapter5/analysis1.prm
# So many that a task of three lasts several seconds on a fast machine: it must
# still run when the test requeues it.
realisations=120
work=$(mktemp -d /tmp/waker-slurm-XXXXXX)
chmod 755 "$work"
daemons=()
failures=0

# shellcheck disable=SC2317
clean_up()
{
  if [ ${#daemons[@]} -gt 1 ]; then # our Slurm: SLURM_CONF
    scancel --quiet --user="$user" 2> /dev/null
    wait_until 15 nothing_queued
  fi
  for daemon in "${daemons[@]}"; do kill "$daemon" 2> /dev/null; done
  for daemon in "${daemons[@]}"; do wait "$daemon" 2> /dev/null; done
  rm -rf "$work"
}
trap clean_up EXIT
trap 'exit 1' INT TERM HUP

check()
{
  if [ "$2" = "$3" ]; then
    echo "ok   $1: $2"
  else
    echo "FAIL $1: $2, not $3"
    failures=$((failures + 1))
  fi
}

give_up()
{
  echo "FAILED: $1"
  tail -n 20 "$work"/*.log "$work"/*.out
  exit 1
}

# wait_until SECONDS COMMAND...: false if the time passes.
wait_until()
{
  local end=$((SECONDS + $1))
  shift
  until "$@"; do
    [ $SECONDS -lt $end ] || return 1
    sleep 0.1
  done
}

# --- Slurm ------------------------------------------------------------------
host=$(hostname -s)
user=$(id -un)
export SLURM_CONF=$work/slurm.conf
# Two ports that nobody listens on.
free_port()
{
  local port
  while :; do
    port=$((20000 + RANDOM % 10000))
    (: < "/dev/tcp/127.0.0.1/$port") 2> /dev/null || break
  done
  echo $port
}
mkdir "$work/munge" "$work/state" "$work/spool"
chmod 755 "$work/munge" # the umask may say otherwise
head -c 128 /dev/urandom > "$work/munge/key"
chmod 600 "$work/munge/key"
cat > "$SLURM_CONF" << END
ClusterName=waker
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket
CredType=cred/munge
SlurmUser=$user
SlurmdUser=$user
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
MailProg=/bin/true
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SwitchType=switch/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=0
SlurmdParameters=config_overrides
ReturnToService=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 RealMemory=8000 State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
END
echo "CgroupPlugin=cgroup/v1" > "$work/cgroup.conf"

munged --foreground --key-file="$work/munge/key" \
  --socket="$work/munge/socket" --pid-file="$work/munge/pid" \
  --seed-file="$work/munge/seed" > "$work/munged.out" 2>&1 &
daemons+=($!)
wait_until 10 test -S "$work/munge/socket" || give_up "munged does not start"
slurmctld -D > "$work/slurmctld.out" 2>&1 &
daemons+=($!)
slurmd -D > "$work/slurmd.out" 2>&1 &
daemons+=($!)
nothing_queued() { [ -z "$(squeue -h 2> /dev/null)" ]; }
node_is_idle() { [ "$(sinfo -h -o %t 2> /dev/null)" = idle ]; }
wait_until 60 node_is_idle || give_up "Slurm does not start"
echo "ok   $(sinfo --version) on $host"

# --- The campaign -------------------------------------------------------------
# Coarse and weak: a fraction of a second each, failing or not.
campaign=("$file"
  --set "Campaign/Realisations=$realisations"
  --set 'Campaign/Batch=5'
  --set 'Grid/Cell size=0.5'
  --set 'Time stepping/Time step=0.005'
  --set 'Time stepping/End time=6'
  --set 'Materials/clay/Initial strength=10'
  --set 'Materials/clay/Residual strength=4')
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
cd "$work" || exit 1
"$WAKER" campaign "${campaign[@]}" --set Output/Directory=one \
  > one.log 2>&1 || give_up "the campaign in one process"
"$WAKER" merge one >> one.log 2>&1 || give_up "merging it"

submit() { sbatch --parsable --chdir="$work" "$@"; }
# field JOB NAME: a word of `scontrol show job`.
field() { scontrol show job "$1" | grep -o "\b$2=[^ ]*" | head -n 1 | cut -d= -f2; }
runs() { [ "$(field "$1" JobState)" = RUNNING ]; }
ended() { [ -z "$(squeue -h -j "$1" 2> /dev/null)" ]; }
waits() { [ "$(field "$1" JobState)" = PENDING ]; }
# A requeued job waits for two minutes, lest it meet its own remains. Their
# credential was revoked by the second: some of them are enough.
hurry()
{
  wait_until 60 waits "$1" || give_up "$1 was not requeued"
  sleep 3
  scontrol update JobId="$1" StartTime=now
}
# Lines of the log of a task, or of the journals of a folder.
n_records() { cat "$1"/journal-*.jsonl /dev/null | grep -c '"realisation"'; }
has_records() { [ "$(n_records "$1")" -ge "$2" ]; }
same()
{
  "${PYTHON:-/usr/bin/python3}" - "$@" "$realisations" << 'END'
import sys
sys.path.insert(0, sys.argv[1])
from campaign_case import Campaign, Checks
check = Checks()
n = int(sys.argv[6])
one, other = (Campaign(sys.argv[2], ".", folder, n) for folder in sys.argv[4:6])
check.once_each(sys.argv[3], other, n)
check.same(sys.argv[3], one.results(), other.results())
check.exit()
END
}

# Each realisation once, with the same outcome; softening makes more of round-off.
same_outcomes()
{
  "${PYTHON:-/usr/bin/python3}" - "$@" "$realisations" << 'END'
import glob
import json
import sys


def outcomes(folder):
    found = []
    for path in glob.glob(folder + "/journal-*.jsonl"):
        for line in open(path, encoding="utf-8"):
            record = json.loads(line)
            if "realisation" in record:
                found.append((record["realisation"], record["outcome"]))
    return sorted(found)


one, other = (outcomes(folder) for folder in sys.argv[1:3])
good = one == other and len(other) == int(sys.argv[3])
print("ok  " if good else "FAIL", "mixed: outcomes",
      sorted(set(one) ^ set(other)))
sys.exit(not good)
END
}
has_checkpoint() { compgen -G "$1/checkpoints/checkpoint-*.bin" > /dev/null; }

# --- The array ------------------------------------------------------------------
array=$(submit --array=1-3 "$scripts/array.slurm" "${campaign[@]}" \
  --set Output/Directory=array) || give_up "sbatch array.slurm"
merge=$(submit --dependency="afterany:$array" "$scripts/merge.slurm" array) ||
  give_up "sbatch merge.slurm"
wait_until 60 has_records array 4 || give_up "the array does not start"
runs "${array}_2" || give_up "task 2 ended too early"
scontrol requeue "${array}_2"
hurry "${array}_2"
wait_until 60 runs "${array}_3" || give_up "task 3 does not run"
sleep 1
scancel --batch --signal=USR1 "${array}_3"
hurry "${array}_3"
check 'merging waits for what is requeued' "$(field "$merge" JobState)" PENDING
wait_until 120 ended "$array" || give_up "the array does not end"
wait_until 60 ended "$merge" || give_up "merging does not end"
check 'task 2 was started again' "$(field "${array}_2" Restarts)" 1
check 'task 3 was started again' "$(field "${array}_3" Restarts)" 1
for task in 1 2 3; do
  check "exit code of task $task" "$(field "${array}_$task" ExitCode)" 0:0
done
for task in 2 3; do
  check "task $task ended cleanly" \
    "$(grep -c 'Interrupted; go on' "waker-${array}_$task.log")" 1
done
check 'exit code of merging' "$(field "$merge" ExitCode)" 0:0
same "$source/tests/cases" "$WAKER" 'array, requeued' one array ||
  failures=$((failures + 1))

# --- MPI ------------------------------------------------------------------------
if srun --mpi=list 2>&1 | grep -q pmix; then
  job=$(submit --ntasks=2 "$scripts/mpi.slurm" "${campaign[@]}" \
    --set Output/Directory=mpi) || give_up "sbatch mpi.slurm"
  wait_until 60 has_records mpi 4 || give_up "the MPI job does not start"
  scontrol requeue "$job"
  hurry "$job"
  wait_until 120 ended "$job" || give_up "the MPI job does not end"
  check 'the MPI job ended cleanly' \
    "$(grep -c 'Interrupted; go on' "waker-$job.log")" 1
  check 'the MPI job was started again' "$(field "$job" Restarts)" 1
  check 'exit code of the MPI job' "$(field "$job" ExitCode)" 0:0
  "$WAKER" merge mpi >> one.log 2>&1 || give_up "merging the MPI job"
  same "$source/tests/cases" "$WAKER" 'MPI, requeued' one mpi ||
    failures=$((failures + 1))

  # --- Two ranks for each realisation; one realisation on two ranks -------------
  job=$(WAKER_RANKS=2 submit --ntasks=2 "$scripts/mixed.slurm" "${campaign[@]}" \
    --set Output/Directory=mixed) || give_up "sbatch mixed.slurm"
  wait_until 60 has_records mixed 4 || give_up "the mixed job does not start"
  scancel --batch --signal=USR1 "$job"
  hurry "$job"
  wait_until 240 ended "$job" || give_up "the mixed job does not end"
  check 'the mixed job ended cleanly' \
    "$(grep -c 'Interrupted; go on' "waker-$job.log")" 1
  check 'exit code of the mixed job' "$(field "$job" ExitCode)" 0:0
  same_outcomes one mixed || failures=$((failures + 1))

  job=$(WAKER_RANKS=2 submit --ntasks=1 "$scripts/mixed.slurm" "${campaign[@]}" \
    --set Output/Directory=odd) || give_up "sbatch mixed.slurm, one task"
  wait_until 60 ended "$job" || give_up "what must be refused does not end"
  check 'two ranks of one are refused' "$(field "$job" ExitCode)" 2:0
  job=$(WAKER_RANKS=2 submit --ntasks=2 "$scripts/mixed.slurm" "${campaign[@]}" \
    --set Output/Directory=odd --nonsense) || give_up "sbatch mixed.slurm, wrong"
  wait_until 60 ended "$job" || give_up "what is wrong does not end"
  check 'what is wrong does not begin again' "$(field "$job" Restarts)" 0

  job=$(submit --ntasks=2 "$scripts/run.slurm" "$file" single --realisation 0 \
    --set 'Grid/Cell size=0.5' --set 'Time stepping/Time step=0.001' \
    --set 'Time stepping/End time=2' \
    --set 'Output/Checkpoint interval=0.05') || give_up "sbatch run.slurm"
  wait_until 60 has_checkpoint single || give_up "the run does not start"
  scontrol requeue "$job"
  hurry "$job"
  wait_until 240 ended "$job" || give_up "the run does not end"
  check 'the run ended cleanly' \
    "$(grep -c 'Interrupted at' "waker-$job.log")" 1
  check 'the run went on' "$(grep -c 'Resumed at' "waker-$job.log")" 1
  check 'exit code of the run' "$(field "$job" ExitCode)" 0:0
else
  echo "not run: this Slurm has no PMIx, and so no MPI job"
fi

[ $failures -eq 0 ] || { tail -n 20 waker-*.log; exit 1; }
