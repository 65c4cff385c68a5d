#!/usr/bin/env bash
# Instructions per particle and step, counted by callgrind: the same on a busy machine as on an idle one.
#
#   benches/instructions.sh            counts and compares with benches/instructions.txt; more than 3 % above it fails
#   benches/instructions.sh --accept   counts and writes benches/instructions.txt
#
# Counted at AVX2 width in one thread, since callgrind knows no AVX-512. The count of STEPS steps less that of none, so that
# building the body does not count.
set -euo pipefail
cd "$(dirname "$0")/.."
file=benches/instructions.txt
steps=20
particles=$((48 * 48))

if ! command -v valgrind > /dev/null; then
    echo "skipped: valgrind is not installed (it counts the instructions)"
    exit 0
fi
cargo build --release -q -p erode-sph --example few_steps
export ERODE_SIMD=avx2 RAYON_NUM_THREADS=1

count() {
    valgrind --tool=callgrind --callgrind-out-file=/dev/null \
        "${CARGO_TARGET_DIR:-target}/release/examples/few_steps" "$1" "$2" 2>&1 |
        sed -n 's/.*Collected : \([0-9]*\).*/\1/p'
}

found=""
for body in water steel; do
    whole=$(count $body $steps)
    start=$(count $body 0)
    found+="$body $(((whole - start) / (steps * particles)))"$'\n'
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
    if [ -n "$before" ] && [ $((now * 100)) -gt $((before * 103)) ]; then
        echo "$body: $now instructions, $before before"
        missed=1
    fi
done <<< "${found%$'\n'}"
exit $missed
