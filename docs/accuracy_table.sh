#!/usr/bin/env bash
# Writes docs/ACCURACY.md from what the accuracy tests print. Build and test first: ./run test
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
bin=build/${1:-release}/bin
out=docs/ACCURACY.md
compgen -G "$bin/accuracy_*" >/dev/null || { echo "accuracy_table: no $bin/accuracy_*; build them with ./run test" >&2; exit 1; }

# A line "QUANTITY: worst W U, RMS R U, N rows, held to L U" becomes a row; what a program is about, its heading.
rows() {
  local program=$1
  VESPER_TEST_FULL=1 "$program" --gtest_brief=1 | sed -n -E \
    's/^ *(.+): worst ([^ ]+) ?(.*), RMS ([^ ]+) ?.*, ([0-9]+) rows, held to ([^ ]+) ?.*$/| \1 | \2 | \4 | \6 | \3 | \5 |/p'
}

temporary=$(mktemp)
trap 'rm -f "$temporary"' EXIT
{
  cat <<'TEXT'
# Accuracy

Every row is a test: it fails when the worst error passes the limit. The references lie in `tests/data`, described
there. Made by `docs/accuracy_table.sh`.

TEXT
  for program in "$bin"/accuracy_*; do
    table=$(rows "$program")
    if [[ -n $table ]]; then
      subject=${program##*/accuracy_}
      printf '## %s\n\n' "${subject//_/ }"
      echo '| quantity | worst | RMS | held to | unit | rows |'
      echo '|---|---|---|---|---|---|'
      printf '%s\n\n' "$table"
    fi
  done
} >"$temporary"
# One blank line ends the file's last table.
sed -i -e '${/^$/d}' "$temporary"
chmod 644 "$temporary"
mv "$temporary" "$out"
trap - EXIT
echo "$out"
