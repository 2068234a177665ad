# shellcheck shell=bash
# What ./run, ./test and .ci/run share: the packages, and how to install, configure and build. To be sourced.

ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
JOBS=$(nproc 2>/dev/null || echo 2)

# Names of Debian 12 and Ubuntu 24.04. The scripts that source this file use the arrays.
# shellcheck disable=SC2034
{
    BUILD_PACKAGES=(cmake ninja-build g++ qt6-base-dev libqt6opengl6-dev qt6-svg-dev qt6-qpa-plugins libgl-dev
        libgl1-mesa-dri libeigen3-dev nlohmann-json3-dev libzstd-dev libxxhash-dev libstb-dev fonts-dejavu-core)
    TEST_PACKAGES=(xvfb xauth)
    BLENDER_PACKAGES=(blender python3-numpy) # huge; only where the test with Blender is required
    FFMPEG_PACKAGES=(ffmpeg)                 # only where the tests of video are required
    BENCH_PACKAGES=(libbenchmark-dev)
    CI_PACKAGES=(ccache clang-format clang-tidy)
}
# Packages that a newer system no longer has under these names; asked for once, not on every start.
NOT_OFFERED=$ROOT/build/packages-not-offered

# Without a UTF-8 locale Qt complains on every start.
[[ $(locale charmap 2>/dev/null) == UTF-8 ]] || export LC_ALL=C.UTF-8

# Standard output belongs to the program and the tests.
say() {
    printf '%s\n' "$*" >&2
}

say_requirements() {
    say "ClothLab needs:
  to build: cmake >= 3.21, ninja, g++ >= 12 or clang >= 14, OpenGL and its headers,
            Qt >= 6.4 (Widgets, OpenGL, OpenGLWidgets, Svg, DBus, Test), Eigen >= 3.4, nlohmann-json >= 3.11, stb,
            zstd >= 1.4, xxHash >= 0.8
  to test:  Xvfb, xvfb-run, xauth, Mesa's software OpenGL, a font such as DejaVu Sans
            Blender >= 3.4 with numpy (only with CLOTHLAB_REQUIRE_BLENDER=1)
            ffmpeg (only with CLOTHLAB_REQUIRE_FFMPEG=1)
  to time:  Google Benchmark (only ./run bench)"
}

as_root() {
    if ((EUID == 0)); then "$@"; else sudo "$@"; fi
}

apt_get() {
    local out=/dev/null
    [[ ! -t 2 ]] || out=/dev/stderr # a person wants to see that it goes on
    as_root env DEBIAN_FRONTEND=noninteractive PATH="$PATH:/usr/sbin:/sbin" \
        apt-get -qq -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3 "$@" </dev/null >$out
}

missing_packages() {
    local installed not_offered package
    # dpkg-query fails when it does not know a package; that is an answer here.
    installed=$(dpkg-query -W -f='${Package}=${db:Status-Status} ' "$@" 2>/dev/null) || true
    not_offered=$(cat "$NOT_OFFERED" 2>/dev/null) || true
    for package in "$@"; do
        [[ " $installed" == *" $package=installed "* || " $not_offered" == *" $package "* ]] || printf '%s ' "$package"
    done
}

# Installs what is missing of the packages. What cannot be installed is said; whether it is to be had in some other
# way, cmake finds out.
need() {
    if ! { command -v apt-get && command -v dpkg-query; } >/dev/null; then
        [[ -e $ROOT/build/release/build.ninja ]] || say_requirements
        return 0
    fi
    local missing offered=() package updated=yes
    read -ra missing <<<"$(missing_packages "$@")"
    ((${#missing[@]} > 0)) || return 0

    say "Installing ${missing[*]}"
    apt_get update || updated=no
    for package in "${missing[@]}"; do
        if [[ $(LC_ALL=C apt-cache policy "$package") == *"Candidate: "[^\(]* ]]; then
            offered+=("$package")
        else
            say "This system offers no package $package."
            [[ $updated == no ]] || { mkdir -p "$ROOT/build" && printf '%s ' "$package" >>"$NOT_OFFERED"; }
        fi
    done
    ((${#offered[@]} == 0)) || apt_get install -y --no-install-recommends "${offered[@]}" ||
        say "These packages could not be installed: ${offered[*]}"
}

# configure PRESET [CMAKE_ARGS]: does nothing when it was done before; the build itself sees to changed CMake files.
configure() {
    local dir=$ROOT/build/$1
    # A build tree does not survive a move of the source tree.
    grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$ROOT" "$dir/CMakeCache.txt" || rm -rf "$dir"
    [[ $# -gt 1 || ! $dir/build.ninja -nt $ROOT/CMakePresets.json ]] || return 0
    (cd "$ROOT" && cmake --preset "$@" >&2) || {
        say_requirements
        return 1
    }
}

# build PRESET [TARGETS]: silent when there is nothing to do.
build() {
    cmake --build "$ROOT/build/$1" -j "$JOBS" --target "${@:2}" |
        sed -u -e '/^ninja: no work to do/d' -e '/Re-checking globbed directories/d' >&2
}

# Runs a command, and returns its status, with an X server of its own where there is one to be had.
with_display() {
    if command -v xvfb-run >/dev/null; then
        xvfb-run -a -s "-screen 0 1600x1200x24" "$@"
    else
        "$@"
    fi
}
