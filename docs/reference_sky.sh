#!/usr/bin/env bash
# Writes docs/REFERENCE_SKY.md and its pictures: the sky of both presets as the reference transport sees it. Needs
# oiiotool (Debian: openimageio-tools) and some twenty minutes on two cores. Build first: ./run demo
# SIZE (64) is the width of a picture in pixels before it is enlarged, PATHS (400) what each pixel gets.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
report=build/release/bin/vesper-report
pictures=docs/pictures/reference
for needed in "$report" oiiotool; do
  command -v "$needed" >/dev/null || { echo "reference_sky: no $needed; see the head of this script" >&2; exit 1; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$pictures"

altitudes=(60 30 10 5 2 0 -2 -4 -6 -8 -10 -12 -15 -18)
presets=(published clear)

# field FILE ROW NAME: a cell of a CSV file by its row (from 1) and the name of its column.
field() {
  awk -F, -v row="$2" -v name="$3" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) column = i; next }
    NR == row + 1 { print $column }' "$1"
}

{
  echo altitude_deg,azimuth_deg,sun_altitude_deg
  for altitude in "${altitudes[@]}"; do echo "90,0,$altitude"; done
} >"$work/zenith.csv"

for preset in "${presets[@]}"; do
  echo "zenith of $preset" >&2
  "$report" sky --reference --medium "$preset" --directions "$work/zenith.csv" --illuminance --relative-error 0.005 \
    --timings -o "$work/$preset.csv"
  for row in $(seq "${#altitudes[@]}"); do
    altitude=${altitudes[row - 1]}
    echo "picture of $preset at $altitude" >&2
    paths=${PATHS:-400}
    if ((altitude < -8)); then paths=$((4 * paths)); fi
    "$report" sky --reference --medium "$preset" --sun-altitude "$altitude" --picture --size "${SIZE:-64}x${SIZE:-64}" \
      --most-paths "$paths" -o "$work/sky.exr"
    # X, Y, Z to linear sRGB; what is as bright as the zenith comes out at 0.3, what is brighter is bent below 1.
    gain=$(awk -v luminance="$(field "$work/$preset.csv" "$row" luminance_cd_m2)" 'BEGIN { print 0.43 / luminance }')
    oiiotool "$work/sky.exr" --ch X,Y,Z --mulc "$gain" \
      --ccmatrix:transpose=1 3.2406,-1.5372,-0.4986,-0.9689,1.8758,0.0415,0.0557,-0.2040,1.0570 \
      --clamp:min=0 --resize:filter=gaussian 256x256 --dup --addc 1 --div --colorconvert linear sRGB \
      --chnames R,G,B -d uint8 -o "$pictures/${preset}_$altitude.png"
  done
done

# Zenith radiances of the published medium as the reference figures have them: a parallel beam, 10 m up.
echo "comparison with tests/data/atmosphere" >&2
"$report" sky --reference --medium published --directions "$work/zenith.csv" --unit-irradiance --sun-radius 0 \
  --height 10 --relative-error 0.004 --timings -o "$work/beam.csv"

zenith_rows() {
  local row altitude preset file
  for row in $(seq "${#altitudes[@]}"); do
    altitude=${altitudes[row - 1]}
    for preset in "${presets[@]}"; do
      file=$work/$preset.csv
      printf '| %s | %s | ![](pictures/reference/%s_%s.png) ' "$altitude" "$preset" "$preset" "$altitude"
      awk -v l="$(field "$file" "$row" luminance_cd_m2)" -v e="$(field "$file" "$row" luminance_error_cd_m2)" \
        -v x="$(field "$file" "$row" x_cd_m2)" -v z="$(field "$file" "$row" z_cd_m2)" \
        -v s="$(field "$file" "$row" s_cd_m2)" -v lux="$(field "$file" "$row" horizontal_illuminance_lux)" \
        -v paths="$(field "$file" "$row" paths)" -v seconds="$(field "$file" "$row" seconds)" 'BEGIN {
          printf "| %.4g | %.2f %% | %.3f, %.3f | %.2f | %.4g | %d | %.1f |\n", l, 100 * e / l, x / (x + l + z),
            l / (x + l + z), s / l, lux, paths, seconds }'
    done
  done
}

beam_rows() {
  local row altitude nm
  for row in $(seq "${#altitudes[@]}"); do
    altitude=${altitudes[row - 1]}
    for nm in 680 550 440; do
      awk -F, -v altitude="$altitude" -v nm="$nm" -v ours="$(field "$work/beam.csv" "$row" "radiance_${nm}nm_per_sr")" \
        -v error="$(field "$work/beam.csv" "$row" "radiance_${nm}nm_error_per_sr")" '
        $2 == altitude && $5 == nm {
          both = sqrt(error ^ 2 + $8 ^ 2 + (1e-4 * $7 / 5) ^ 2)
          printf "| %s | %s | %.4e | %.2f %% | %.4e | %.2f %% | %.4f | %+.1f |\n", altitude, nm, ours,
            100 * error / ours, $7, 100 * $8 / $7, ours / $7, (ours - $7) / both }' \
        tests/data/atmosphere/sky_zenith_radiance.csv
    done
  done
}

fit_rows() {
  awk -F, 'NR > 1 { print "90,0," $1 - ($1 >= 0 ? 1 / (60 * tan_deg($1 + 7.31 / ($1 + 4.4))) : 0) }
    function tan_deg(d) { d *= 3.14159265358979 / 180; return sin(d) / cos(d) }' \
    tests/data/atmosphere/illuminance_clear_sky.csv >"$work/rows"
  { echo altitude_deg,azimuth_deg,sun_altitude_deg; cat "$work/rows"; } >"$work/fit_places.csv"
  "$report" sky --reference --directions "$work/fit_places.csv" --illuminance --relative-error 0.01 -o "$work/fit.csv"
  local row=0 apparent fit rest
  while IFS=, read -r apparent fit rest; do
    row=$((row + 1))
    awk -v apparent="$apparent" -v fit="$fit" -v true="$(field "$work/fit.csv" "$row" sun_altitude_deg)" \
      -v ours="$(field "$work/fit.csv" "$row" horizontal_illuminance_lux)" 'BEGIN {
        printf "| %s | %.2f | %.4g | %.4g | %.2f |\n", apparent, true, ours, fit, ours / fit }'
  done < <(tail -n +2 tests/data/atmosphere/illuminance_clear_sky.csv)
}

{
  cat <<'TEXT'
# The sky as the reference sees it

Spectral Monte Carlo of all orders in the spherical atmosphere (`vesper/atmosphere/reference_transport.hpp`), straight
rays, no clouds. Made by `docs/reference_sky.sh` from `vesper-report sky --reference`. What is compared here stands as
tests too, in [ACCURACY.md](ACCURACY.md); what the published methods make of the same zenith, in
[BASELINES.md](BASELINES.md).

## Zenith and horizon
The whole sky: zenith in the middle, the Sun to the south (below), east on the left, without the Sun's disc. Each picture
is as bright as its own zenith. Luminance of the zenith (cd/m2) with its standard error, its chromaticity (CIE 1931 x, y)
and S/Y, scotopic over photopic luminance; illuminance of level ground (lux) by Sun and sky; paths and seconds that
zenith and illuminance took together on one core of two. `published` is known at three wavelengths and taken as constant
beyond them.

| Sun, degrees | medium | sky | zenith | error | x, y | S/Y | lux | paths | s |
|---|---|---|---|---|---|---|---|---|---|
TEXT
  zenith_rows
  cat <<'TEXT'

## The zenith against another Monte Carlo
Radiance of the zenith of `published` (1/sr above an irradiance of 1) for a parallel beam, against
`tests/data/atmosphere/sky_zenith_radiance.csv`; the last column is the difference in combined standard errors, with
1e-4 allowed for the figures' rounding. The test holds it to 5.

| Sun, degrees | nm | ours | error | theirs | error | ratio | deviation |
|---|---|---|---|---|---|---|---|
TEXT
  beam_rows
  cat <<'TEXT'

## Illuminance against measured light
Level ground under `clear`, against the fit of US Naval Observatory Circular 171 to another day's air
(`tests/data/atmosphere/illuminance_clear_sky.csv`). Its altitudes from 0 up are apparent; ours are what they are
without refraction. Held to a factor of 1.4 above 0 degrees, 2.5 to -8 and 4.5 to -12.

| apparent, degrees | airless, degrees | ours, lux | fit, lux | ratio |
|---|---|---|---|---|
TEXT
  fit_rows
} >"$work/page.md"
chmod 644 "$work/page.md"
mv "$work/page.md" docs/REFERENCE_SKY.md
echo docs/REFERENCE_SKY.md
