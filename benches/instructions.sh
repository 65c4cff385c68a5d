#!/usr/bin/env bash
# Instructions per particle and step, counted by callgrind: the same on a busy machine as on an idle one.
#
#   benches/instructions.sh            counts and compares with benches/instructions.txt; more than 3 % above it fails
#   benches/instructions.sh --accept   counts and writes benches/instructions.txt
#
# Counted at AVX2 width in one thread, since callgrind knows no AVX-512. The count of STEPS steps less that of none, so that
# building the body does not count. Ends with 0 only if every body was counted and compared; with 77 if valgrind is missing.
set -euo pipefail
cd "$(dirname "$0")/.."
file=benches/instructions.txt
bodies="water steel"
steps=20
particles=$((48 * 48))

fail() {
    echo "$*" >&2
    exit 1
}

if ! command -v valgrind > /dev/null; then
    echo "nothing was counted: valgrind is not installed" >&2
    exit 77
fi
if ! grep -q avx2 /proc/cpuinfo; then
    fail "nothing was counted: this processor has no AVX2, for which $file was counted"
fi
cargo build --release -q -p erode-sph --example few_steps
export ERODE_SIMD=avx2 RAYON_NUM_THREADS=1

count() {
    local log number
    log=$(valgrind --tool=callgrind --callgrind-out-file=/dev/null \
        "${CARGO_TARGET_DIR:-target}/release/examples/few_steps" "$1" "$2" 2>&1) || fail "$log"
    number=$(sed -n 's/.*Collected : \([0-9]*\).*/\1/p' <<< "$log")
    [[ $number =~ ^[1-9][0-9]*$ ]] || fail "callgrind told no count for $1: $log"
    echo "$number"
}

found=""
for body in $bodies; do
    whole=$(count "$body" $steps)
    start=$(count "$body" 0)
    each=$(((whole - start) / (steps * particles)))
    [ "$each" -gt 0 ] || fail "$body: $steps steps took no more instructions than none"
    found+="$body $each"$'\n'
done
printf 'instructions per particle and step:\n%s' "$found"

if [ "${1:-}" = --accept ]; then
    printf '%s' "$found" > "$file"
    echo "written to $file"
    exit 0
fi
missed=0
while read -r body now; do
    before=$(awk -v body="$body" '$1 == body { print $2 }' "$file")
    [[ $before =~ ^[1-9][0-9]*$ ]] || fail "$file has no count of $body to compare with; --accept writes it"
    if [ $((now * 100)) -gt $((before * 103)) ]; then
        echo "$body: $now instructions, $before before"
        missed=1
    fi
done <<< "${found%$'\n'}"
exit $missed
