#!/bin/sh
# Proves the set-up on a machine that has nothing: makes a bare Debian in a folder, clones this repository into it, and
# runs one command of ./contact there. By hand and before a release; it takes a network, root and some 6 GB.
#
#   tools/bare_debian.sh [--release 12|13] [--minutes N] [--user | --container] [--folder DIR] [--keep]
#                        [ARGUMENTS OF ./contact]
#
# Without arguments it runs ./contact test. --user runs as a user with sudo instead of as root. --container first does what
# .devcontainer does: its install.sh as root, then its onCreateCommand as the user that it makes. --keep leaves the
# folder; a kept folder given again with --folder is used again, with a new clone. Servers, proxies and certificates
# are those that this machine's own apt is configured with. Mounts are made in a namespace of their own, so nothing
# outside the folder is touched and nothing stays mounted. Ubuntu is not offered: it has an archive of its own.
set -eu

root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
release=12
minutes=90
user=root
folder=''
keep=no
container=no

fail() {
  printf 'bare_debian: %s\n' "$*" >&2
  exit 2
}

while [ $# -gt 0 ]; do
  case $1 in
    --release) release=${2-} && shift 2 ;;
    --minutes) minutes=${2-} && shift 2 ;;
    --folder) folder=${2-} && shift 2 ;;
    --user) user=reader && shift ;;
    --container) container=yes && user=reader && shift ;;
    --keep) keep=yes && shift ;;
    -h | --help) sed -n '2,/^set/s/^# \{0,1\}//p' "$0" && exit 0 ;;
    --) shift && break ;;
    -*) fail "no option $1" ;;
    *) break ;;
  esac
done
[ $# -gt 0 ] || set -- test

case $release in
  12) codename=bookworm ;;
  13) codename=trixie ;;
  *) fail "--release takes 12 or 13, not \"$release\"" ;;
esac
case $minutes in
  '' | *[!0-9]*) fail "--minutes takes a whole number, not \"$minutes\"" ;;
esac
[ "$(id -u)" -eq 0 ] || fail "debootstrap and chroot take root"
command -v debootstrap > /dev/null || fail "debootstrap is missing (apt-get install debootstrap)"

# The same servers as this machine's, for another release: label -> address.
# shellcheck disable=SC2016 # apt's own variables
servers=$(apt-get indextargets --format '$(LABEL)|$(REPO_URI)' 'Created-By: Packages' | sort -u)
mirror=$(printf '%s\n' "$servers" | sed -n 's/^Debian|//p' | head -n 1)
security=$(printf '%s\n' "$servers" | sed -n 's/^Debian-Security|//p' | head -n 1)
[ -n "$mirror" ] || fail "this machine's apt names no Debian server; run apt-get update first"

# Everything below runs in mount and process namespaces of its own, which end with it.
if [ "${CONTACT_BARE_INSIDE-}" != yes ]; then
  CONTACT_BARE_INSIDE=yes
  export CONTACT_BARE_INSIDE
  set -- --release "$release" --minutes "$minutes" -- "$@"
  [ "$keep" = no ] || set -- --keep "$@"
  if [ "$container" = yes ]; then
    set -- --container "$@"
  elif [ "$user" != root ]; then
    set -- --user "$@"
  fi
  [ -z "$folder" ] || set -- --folder "$folder" "$@"
  exec unshare --mount --pid --fork --kill-child --propagation private "$root/tools/bare_debian.sh" "$@"
fi

[ -n "$folder" ] || folder=$(mktemp -d /var/tmp/contact-hours-bare.XXXXXX)
mkdir -p "$folder"
chmod 755 "$folder" # it becomes the root, which --user must be able to enter
folder=$(CDPATH='' cd -- "$folder" && pwd)
mounted=no
# shellcheck disable=SC2317 # called by the trap
finish() {
  code=$?
  trap - EXIT
  if [ "$mounted" = yes ]; then
    umount "$folder/proc" || true
    umount -R -l "$folder/dev" || true
  fi
  if [ "$keep" = yes ]; then
    printf 'Kept: %s\n' "$folder"
  elif [ -n "$(awk -v f="$folder/" 'index($2, f) == 1' /proc/self/mounts)" ]; then
    printf 'Something is still mounted under %s, so it is left as it is.\n' "$folder" >&2
  else
    rm -rf --one-file-system "$folder"
  fi
  exit "$code"
}
trap finish EXIT
trap 'exit 130' INT
trap 'exit 143' TERM

seconds() { date +%s; }
began=$(seconds)
if [ ! -x "$folder/bin/sh" ]; then
  printf 'Making a bare Debian %s (%s) in %s\n' "$release" "$codename" "$folder"
  debootstrap --variant=minbase "$codename" "$folder" "$mirror" > "$folder.log" 2>&1 || {
    tail -n 15 "$folder.log"
    rm -f "$folder.log"
    fail "debootstrap could not make it"
  }
  rm -f "$folder.log"
  {
    printf 'deb %s %s main\n' "$mirror" "$codename"
    printf 'deb %s %s-updates main\n' "$mirror" "$codename"
    [ -z "$security" ] || printf 'deb %s %s-security main\n' "$security" "$codename"
  } > "$folder/etc/apt/sources.list"
  # How this machine reaches its servers.
  apt-config dump | grep -E '^Acquire::(http|https|ftp|Check-|Retries|ForceIPv)' > "$folder/etc/apt/apt.conf.d/80host" || true
  printf '127.0.0.1 localhost\n' > "$folder/etc/hosts"
fi
cp -L /etc/resolv.conf "$folder/etc/resolv.conf"
# Certificates that this machine's owner added: picked up when ./contact setup installs ca-certificates.
mkdir -p "$folder/usr/local/share/ca-certificates"
find /usr/local/share/ca-certificates -name '*.crt' -exec cp {} "$folder/usr/local/share/ca-certificates/" \; 2> /dev/null || true

mount -t proc proc "$folder/proc"
mount --rbind /dev "$folder/dev"
mounted=yes

# Runs a command there. The folder becomes the true root of a mount namespace: after a plain chroot the kernel allows no
# user namespaces, in which submissions are graded.
inside() {
  # shellcheck disable=SC2016 # expanded in there
  unshare --mount sh -ec 'mount --rbind "$1" "$1" && cd "$1" && shift && mkdir -p .outside &&
    pivot_root . .outside && umount -l /.outside && exec chroot . "$@"' sh "$folder" "$@"
}

# A clean environment, except for the network settings.
kept_environment=$(env | grep -E '^(https?_proxy|HTTPS?_PROXY|no_proxy|NO_PROXY|PIP_CERT|PIP_INDEX_URL|PIP_DEFAULT_TIMEOUT|NODE_EXTRA_CA_CERTS|SSL_CERT_FILE|npm_config_registry)=' || true)

home=/root
if [ "$container" = yes ]; then
  rm -rf "$folder/opt/contact-hours"
  git clone -q --no-hardlinks "$root" "$folder/opt/contact-hours"
  # shellcheck disable=SC2086 # NAME=value words, none with spaces
  inside env $kept_environment /opt/contact-hours/.devcontainer/install.sh > "$folder/var/log/image.log" 2>&1 || {
    tail -n 15 "$folder/var/log/image.log"
    fail "the image's steps failed"
  }
  rm -rf "$folder/opt/contact-hours"
  home=/home/$user
elif [ "$user" != root ]; then
  home=/home/$user
  inside sh -c "command -v sudo > /dev/null || { apt-get -qq update && apt-get -qq -y install sudo > /dev/null; }
    id $user > /dev/null 2>&1 || useradd --create-home $user
    printf '%s ALL=(ALL) NOPASSWD:ALL\n' $user > /etc/sudoers.d/$user"
fi
rm -rf "${folder:?}$home/contact-hours"
git clone -q --no-hardlinks "$root" "$folder$home/contact-hours"
[ -z "$(git -C "$root" status --porcelain)" ] || printf 'Not committed, so not in the clone:\n%s\n' "$(git -C "$root" status --porcelain)"
[ "$user" = root ] || inside chown -R "$user:" "$home/contact-hours"

printf 'Made in %s s. Commit %s. Running there, as %s: ./contact %s\n' "$(($(seconds) - began))" \
  "$(git -C "$root" rev-parse --short HEAD)" "$user" "$*"
log=$folder/var/log/contact-hours.log
# Runs ./contact there, with the arguments given.
contact_there() {
  # shellcheck disable=SC2086 # NAME=value words, none with spaces
  inside timeout --kill-after=30 "$((minutes * 60))" su "$user" -s /bin/sh -c \
    'cd ~/contact-hours && exec env "$@"' -- sh -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    HOME="$home" LANG=C.UTF-8 $kept_environment ./contact "$@" < /dev/null
}
began=$(seconds)
code=0
if [ "$container" = yes ]; then
  created=$(sed -n 's/^ *"onCreateCommand": "\.\/contact \(.*\)",$/\1/p' "$root/.devcontainer/devcontainer.json")
  # shellcheck disable=SC2086 # its words
  contact_there $created > "$log" 2>&1 || fail "./contact $created failed there: $(tail -n 5 "$log")"
  printf 'The container is up after %s s more (./contact %s)\n' "$(($(seconds) - began))" "$created"
  began=$(seconds)
fi
contact_there "$@" > "$log" 2>&1 || code=$?
took=$(($(seconds) - began))
printf -- '--- last lines\n'
tail -n 40 "$log"
printf -- '---\nDebian %s, ./contact %s: exit code %s after %s min %s s\n' "$release" "$*" "$code" "$((took / 60))" "$((took % 60))"
[ "$code" -ne 124 ] || printf 'Stopped at the limit of %s minutes.\n' "$minutes"
exit "$code"
