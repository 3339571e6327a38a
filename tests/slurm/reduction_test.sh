#!/bin/sh
# reduction_test.sh SIGNORINI FOLDER: inside a job of Slurm two processes share the factors of a reduction, started by mpirun
# on two nodes and by srun on one; the reduced scenes move as that of one process. Exit code 77 where no Slurm or MPI can be
# had.
set -eu

program=$1
folder=$2
here=$(dirname -- "$0")

fail() {
  echo "failed: $*" >&2
  cat "$folder/log.txt" >&2 || true
  exit 1
}

for needed in "$program-reduce-mpi" mpirun; do
  command -v "$needed" >/dev/null || { echo "skipped: no $needed" && exit 77; }
done
. "$here/in_cluster.sh"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 # Slurm's daemons need root, and so their jobs run

# Two nodes of one host share the folder in which Slurm's PMIx keeps a step's files, hence srun on one of them.
names='mpirun srun'
srun --mpi=list 2>&1 | grep -qw pmix || names=mpirun
cat >"$folder/job.sh" <<END
#!/bin/sh
set -eu
reduce() { '$program' reduce block-nine-contacts --out '$folder'/by-"\$1".toml --mpi 2 --launcher "\$2"; }
reduce mpirun mpirun
[ '$names' = mpirun ] || reduce srun 'srun --mpi=pmix --nodes=1 --overcommit --overlap'
END
timeout 300 sbatch --quiet --wait --nodes=2 --ntasks=2 --output="$folder/log.txt" "$folder/job.sh" || fail 'the job'

# motion FILE: what the reduced scene does, to six digits.
motion() { "$program" solve "$1" --method hat-lcp --set samples=256 --verbose | sed -n '/^displacement/,/^impacts/p'; }

"$program" reduce block-nine-contacts --out "$folder/alone.toml" >/dev/null
motion "$folder/alone.toml" >"$folder/alone.motion"
[ "$(wc -l <"$folder/alone.motion")" -eq 11 ] || fail 'nine contacts were expected'
for name in $names; do
  motion "$folder/by-$name.toml" | cmp - "$folder/alone.motion" || fail "another motion by $name"
  echo "two processes by $name: the same motion as one"
done
