# Sourced by ./run and ./test: installing, configuring and building, a line and a log for each phase.
# Everything is said on standard error, so that the output of `./run VERB` stays clean.
cd "$(dirname "${BASH_SOURCE[0]}")/../.." || exit 3
logs=build/log
packages=framework/cmake/packages.txt
jobs=$(nproc)
apt_line='apt-get install -y --no-install-recommends'
mkdir -p "$logs"

say() { printf '%s\n' "$*" >&2; }

# Copies its input to a log. On a terminal the newest line is shown too, in place.
watched() {
    if [ ! -t 2 ]; then
        cat >"$1"
        return
    fi
    local line
    while IFS= read -r line; do
        printf '%s\n' "$line" >&3
        printf '\r\033[K  %s' "${line:0:${COLUMNS:-80}-4}" >&2
    done 3>"$1"
    printf '\r\033[K' >&2
}

# phase NAME COMMAND…: runs it; one line with the seconds, or the end of its log and its exit status.
phase() {
    local name=$1 start=$SECONDS log=$logs/$1.log status
    shift
    [ ! -t 2 ] || printf '%s …' "$name" >&2
    "$@" 2>&1 </dev/null | watched "$log"
    status=${PIPESTATUS[0]}
    if [ "$status" = 0 ]; then
        say "$(printf '%-10s %4d s' "$name" $((SECONDS - start)))"
        return
    fi
    say "$name failed after $((SECONDS - start)) s. The end of $log:"
    tail -n 40 "$log" | sed 's/^/  | /' >&2
    exit "$status"
}

# wanted NEED…: the packages that the list gives for these needs.
wanted() {
    local need package for_what
    while read -r need package for_what; do
        case " $* " in *" $need "*) echo "$package" ;; esac
    done <"$packages"
}

# missing PACKAGE…: those that are not installed.
missing() {
    local installed package
    installed=$(dpkg-query -W -f='${Package} ${db:Status-Status}\n' "$@" 2>/dev/null)
    for package; do
        grep -qxF "$package installed" <<<"$installed" || echo "$package"
    done
}

# as_root COMMAND…: as the superuser, asking nobody.
as_root() {
    if [ "$(id -u)" = 0 ]; then "$@"; else sudo -n "$@"; fi
}

apt_install() {
    local apt=(env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=120)
    as_root "${apt[@]}" update || echo "apt-get update failed; trying with the lists that are here"
    as_root "${apt[@]}" install -y --no-install-recommends "$@"
}

# install NEED…: installs what is missing for these needs; calls apt only when something is.
install() {
    local names lacking
    names=$(wanted "$@")
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        say "This is not Debian, so nothing is installed. Needed, by Debian's names:" $names
        return
    fi
    lacking=$(missing $names)
    [ -n "$lacking" ] || return 0
    if [ "$(id -u)" != 0 ] && ! sudo -n true 2>/dev/null; then
        say "Packages are missing, and installing them needs the superuser. Paste this, then try again:"
        say
        say "    sudo apt-get update && sudo $apt_line" $lacking
        exit 1
    fi
    phase install apt_install $lacking
}

# build TESTING TARGET: TESTING is ON when the tests are wanted too; once on, it stays on.
build() {
    local testing
    testing=$(sed -n 's/^BUILD_TESTING:BOOL=//p' build/release/CMakeCache.txt 2>/dev/null)
    if [ ! -f build/release/build.ninja ] || { [ "$1" = ON ] && [ "$testing" != ON ]; }; then
        phase configure cmake --preset release -DBUILD_TESTING="$1"
    fi
    phase build cmake --build --preset release --parallel "$jobs" --target "$2"
}
