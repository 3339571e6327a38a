# Read by the tests here, which have set $here and $folder: an empty $folder, and in it a cluster for as long as the script
# runs. Exit code 77, with the reason, where none can be had.
# shellcheck shell=sh disable=SC2154
rm -rf "$folder"
mkdir -p "$folder"
trap 'sh "$here/cluster.sh" down "$folder/cluster"' EXIT
trap 'exit 1' HUP INT TERM
sh "$here/cluster.sh" up "$folder/cluster" || exit $?
export SLURM_CONF="$folder/cluster/slurm.conf"
