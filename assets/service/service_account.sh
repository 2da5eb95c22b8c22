#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Gives a store to a service account that nobody signs in with, so that people who practise can use the window and cannot reach the
# store's file or the station's key. Debian, as root:
#   service_account.sh [--print] GROUP STORE KEYS PROGRAM
#     --print   prints the commands and changes nothing
#     GROUP     people of this group may start the program as the service account
#     STORE     the store that is moved, such as ~skills/.local/share/fulcrum/fulcrum.db
#     KEYS      the folder of the station's keys, such as ~skills/.config/fulcrum/keys
#     PROGRAM   the program, such as /usr/bin/fulcrum
# What exists in the place of the new store is never replaced. A second run after an interruption continues; where it was cut off while
# it copied the store from another disk, it says what to do.
set -euo pipefail

account=fulcrum home=/var/lib/fulcrum rights=/etc/sudoers.d/fulcrum
data=$home/.local/share/fulcrum keys_at=$home/.config/fulcrum/keys

refuse() { echo "service_account.sh: $1" >&2; exit 2; }
print=no
if [ "${1:-}" = --print ]; then
    print=yes
    shift
fi
[ $# -eq 4 ] || refuse "usage: service_account.sh [--print] GROUP STORE KEYS PROGRAM"
group=$1 store=$2 keys=$3 program=$4
run() { if [ $print = yes ]; then printf '%q ' "$@" | sed 's/ $//'; echo; else "$@"; fi; }

case "$group" in *[!a-z0-9_-]* | "") refuse "'$group' is no name of a group: lower-case letters, digits, - and _" ;; esac
getent group "$group" >/dev/null || refuse "there is no group '$group': groupadd $group, then adduser PERSON $group"
for path in "$store" "$keys" "$program"; do
    [ ! -L "$path" ] || refuse "$path is a link: name the file or folder itself"
done
[ -f "$store" ] || [ -f "$data/fulcrum.db" ] || refuse "there is no store $store"
[ -d "$keys" ] || [ -d "$keys_at" ] || refuse "there is no folder of keys $keys"
case "$program" in /*) ;; *) refuse "PROGRAM: its whole path, as sudo needs it" ;; esac
case "$program" in *[!A-Za-z0-9/._-]*) refuse "PROGRAM: a path of letters, digits, / . _ and - alone, as sudo reads it" ;; esac
[ -x "$program" ] || refuse "there is no program $program"
[ ! -f "$store" ] || [ ! -e "$data/fulcrum.db" ] ||
    refuse "there is a store in $data already, nothing was changed; if a run was cut off while it copied $store there, remove the copy"
if [ -f "$store" ]; then
    whole=$(realpath "$store")
    # One program for all of them: there are thousands, and a program for each took half a minute on a busy machine.
    holder=$(find /proc/[0-9]*/fd -maxdepth 1 -type l -printf '%p\t%l\n' 2>/dev/null |
        while IFS=$'\t' read -r open target; do
            if [ "$target" = "$whole" ]; then
                open=${open#/proc/}
                echo "${open%%/*}"
                break
            fi
        done || true)
    [ -z "$holder" ] || refuse "process $holder has the store open: end the program on every screen"
fi
if [ $print = no ]; then
    [ "$(id -u)" -eq 0 ] || refuse "only root can do this"
    command -v sudo >/dev/null || refuse "sudo is missing: apt install sudo"
    # Whoever can write the program can do with the store what the account can.
    [ -z "$(find "$program" \( ! -user root -o -perm /022 \))" ] || refuse "$program has to belong to root, and nobody else may write it"
    number=$(id -u "$account" 2>/dev/null || echo 1)
    [ "$number" -ge 1 ] && [ "$number" -le 999 ] || refuse "the account $account is a person's: rename it"
fi

getent passwd "$account" >/dev/null || run adduser --system --group --home "$home" "$account"
run install -d -o "$account" -g "$account" -m 0700 "$home" "$home/.local" "$home/.local/share" "$data" "$home/.config" "$home/.config/fulcrum" "$keys_at"
if [ -d "$keys" ]; then
    for key in "$keys"/*; do
        [ ! -f "$key" ] || run mv -n "$key" "$keys_at/"
    done
fi
# The log first: without it the store would lose what it holds.
for ending in -wal -shm .frames ""; do
    [ ! -e "$store$ending" ] || run mv -n "$store$ending" "$data/fulcrum.db$ending"
done
run chown -R "$account:$account" "$home"
run chmod -R go= "$home"
rule="%$group ALL=($account) NOPASSWD: $program \"\""  # the window alone: no arguments
if [ $print = yes ]; then
    echo "echo '$rule' > $rights"
else
    new=$(mktemp)
    echo "$rule" >"$new"
    visudo -cf "$new" >/dev/null || refuse "sudo does not accept the rule: $rule"
    install -m 0440 "$new" "$rights"
    rm -f "$new"
fi
run sudo -u "$account" -H "$program" db check --quick
[ $print = yes ] || echo "Done. People of the group $group start: xhost +si:localuser:$account && sudo -u $account -H $program"
