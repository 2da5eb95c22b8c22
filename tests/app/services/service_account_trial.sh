#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Carries service_account.sh out as root where it changes nothing of this machine: in a mount namespace whose /etc, /var/lib and /opt
# are folders of FOLDER. Prints who can do what afterwards, a line each.
#   unshare --mount --propagation private bash service_account_trial.sh FOLDER
#     FOLDER/opt    has the program fulcrum, service_account.sh, and home/ with fulcrum.db and keys/
set -euo pipefail
if [ "$(readlink /proc/self/ns/mnt)" = "$(readlink "/proc/$PPID/ns/mnt")" ]; then
    echo "service_account_trial.sh: not in a mount namespace of its own, nothing was changed" >&2
    exit 2
fi
cd "$1"
export PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C
unset FULCRUM_STATION_KEYS FULCRUM_ASSETS HOME
cp -a /etc etc
mkdir lib
for folder in etc lib opt; do chmod 0755 "$folder"; done
mount --bind etc /etc
mount --bind lib /var/lib
mount --bind opt /opt

# The account that people practise with: it has the store, and its group may start the window.
printf 'skills:x:1500:\nskillslab:x:1501:skills\n' >>/etc/group
echo 'skills:x:1500:1500::/opt/home:/bin/bash' >>/etc/passwd
echo 'skills:*:19000:0:99999:7:::' >>/etc/shadow
chown -R skills:skills /opt/home

set_up() { bash /opt/service_account.sh skillslab /opt/home/fulcrum.db /opt/home/keys /opt/fulcrum; }
set_up
set_up  # the second time nothing is left to move

data=/var/lib/fulcrum/.local/share/fulcrum keys=/var/lib/fulcrum/.config/fulcrum/keys
trainee() { setpriv --reuid=skills --regid=skills --init-groups "$@"; }
can() {
    local what=$1
    shift
    if "$@" >/dev/null 2>&1; then echo "$what: yes"; else echo "$what: no"; fi
}
can "trainee starts programs" trainee /opt/fulcrum --version
can "trainee reads the store" trainee cat "$data/fulcrum.db"
can "trainee opens the store" trainee /opt/fulcrum db check --quick --db "$data/fulcrum.db"
can "trainee lists the folder" trainee ls /var/lib/fulcrum
can "trainee moves the folder" trainee mv /var/lib/fulcrum /var/lib/elsewhere
can "trainee has keys" trainee ls "$keys"
can "trainee finds the old store" trainee ls /opt/home/fulcrum.db
can "trainee starts the window" sudo -n -l -U skills -u fulcrum /opt/fulcrum
can "trainee runs a command" sudo -n -l -U skills -u fulcrum /opt/fulcrum db check
can "trainee runs a shell" sudo -n -l -U skills -u fulcrum /bin/sh
can "others start the window" sudo -n -l -U nobody -u fulcrum /opt/fulcrum
can "account signs in" trainee sh -c 'getent passwd fulcrum | grep -vE "/(nologin|false)$"'
can "account opens the store" sudo -n -u fulcrum -H /opt/fulcrum db check
stat -c '%U:%G %a %n' /var/lib/fulcrum "$data" "$keys" "$data"/* "$keys"/* /etc/sudoers.d/fulcrum
