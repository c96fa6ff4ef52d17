#!/bin/sh
# cluster.sh - a Slurm of several nodes on this machine, in a folder of its own, without systemd
# SPDX-License-Identifier: Apache-2.0
#
# usage: cluster.sh start FOLDER N      munged, slurmctld, and slurmd for nodes node1 to nodeN of a
#                                       processor each; prints nothing when all are idle
#        cluster.sh kill FOLDER NODE    ends node and all of its processes at once, as when power is
#                                       lost
#        cluster.sh stop FOLDER         ends all of it
# Then SLURM_CONF=FOLDER/slurm.conf sbatch ... Runs as whoever calls it, root or not. Exit code 3:
# there is no Slurm here.
set -u
folder=$2
PATH=$PATH:/usr/sbin:/sbin
export SLURM_CONF="$folder/slurm.conf"
first=${SLURM_TEST_PORT:-16820} # this one and N + 1 more

configure() { # nodes
    host=$(hostname -s)
    cat <<END
ClusterName=here
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$first
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
CredType=cred/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/%n.spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdPidFile=$folder/%n.pid
SlurmdLogFile=$folder/%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
SlurmdTimeout=10
ReturnToService=2
MailProg=/bin/true
SchedulerParameters=batch_sched_delay=0,sched_interval=2
PartitionName=all Nodes=ALL Default=YES State=UP
END
    for n in $(seq "$1"); do
        echo "NodeName=node$n NodeHostname=$host NodeAddr=127.0.0.1 Port=$((first + n)) CPUs=1"
    done
}

start() { # nodes
    for program in munged slurmctld slurmd sbatch; do
        command -v $program >/dev/null || {
            echo "no $program here: make slurm-setup" >&2
            exit 3
        }
    done
    mkdir -p "$folder/state"
    chmod 755 "$folder"
    configure "$1" >"$folder/slurm.conf"
    (umask 077 && head -c 1024 /dev/urandom >"$folder/munge.key")
    munged --force --key-file="$folder/munge.key" --socket="$folder/munge.socket" \
        --pid-file="$folder/munged.pid" --log-file="$folder/munged.log" \
        --seed-file="$folder/munged.seed" 2>"$folder/munged.err" ||
        { cat "$folder/munged.err" >&2 && exit 1; }
    slurmctld 2>"$folder/slurmctld.err" || { cat "$folder/slurmctld.err" >&2 && exit 1; }
    for n in $(seq "$1"); do
        mkdir -p "$folder/node$n.spool"
        slurmd -N "node$n" 2>"$folder/node$n.err" || { cat "$folder/node$n.err" >&2 && exit 1; }
    done
    tries=0
    until [ "$(sinfo -h -N -t idle -o %N 2>/dev/null | wc -l)" -ge "$1" ]; do
        tries=$((tries + 1))
        [ $tries -lt 60 ] || { sinfo -N >&2 && tail -n 5 "$folder"/*.log >&2 && exit 1; }
        sleep 1
    done
}

# Processes of the node's jobs, and what watches them; slurmd itself is not one of them.
of_node() {
    for process in /proc/[0-9]*; do
        { tr '\0' '\n' <"$process/environ"; } 2>/dev/null >"$folder/environ" || continue
        grep -qx "SLURMD_NODENAME=$1" "$folder/environ" || continue
        grep -qx "SLURM_CONF=$SLURM_CONF" "$folder/environ" || continue # not of this cluster
        parent=$(sed -n 's/^PPid:\t//p' "$process/status" 2>/dev/null)
        echo "${process#/proc/}"
        grep -q '^slurmstepd' "/proc/${parent:-0}/comm" 2>/dev/null && echo "$parent"
    done | sort -u
}

end_of() { # pid file: the daemon, politely; it is gone afterwards
    pid=$(cat "$folder/$1" 2>/dev/null) || return 0
    kill "$pid" 2>/dev/null || return 0
    for _ in 1 2 3 4 5 6 7 8 9 10; do
        kill -0 "$pid" 2>/dev/null || return 0
        sleep 0.5
    done
    kill -9 "$pid"
}

case $1 in
start) start "$3" ;;
kill)
    # shellcheck disable=SC2046  # words
    kill -9 "$(cat "$folder/$3.pid")" $(of_node "$3") 2>/dev/null
    rm -f "$folder/$3.pid"
    ;;
stop)
    scancel -u "$(id -un)" 2>/dev/null
    for file in "$folder"/node*.pid; do [ -f "$file" ] && end_of "${file##*/}"; done
    end_of slurmctld.pid
    end_of munged.pid
    ;;
*) sed -n '4,9s/^# //p' "$0" >&2 && exit 2 ;;
esac
