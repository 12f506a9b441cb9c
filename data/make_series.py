#!/usr/bin/env python3
"""Makes renderer/astro/elp_mpp02_terms.inl and vsop87_terms.inl: the Moon's and the planets' theories, cut short.

Usage: python3 data/make_series.py elpMppDeFull.js /usr/share/kstars renderer/astro

The Moon: ELP/MPP02 (Chapront and Francou 2003, A&A 404, 735) with the constants fitted to DE405. The first argument is
the whole theory (35901 terms, longitude and latitude in arcsec, distance in km, the phases as polynomials of centuries)
in the form that the library `astronomia` 4.2.0 carries in data/elpMppDeFull.js. The planets: VSOP87B (Bretagnon and
Francou 1988, A&A 202, 309), heliocentric spherical coordinates in the ecliptic and equinox J2000, from the files
PLANET.COORDINATEpower.vsop of the Debian package kstars-data (amplitude in rad or au, phase, frequency per millennium).

Kept are the terms whose amplitude reaches a threshold at a given distance from J2000. Every number is rounded to the
digits that matter `far` away. Same input, same bytes.
"""

import hashlib
import json
import math
import os
import re
import sys

ARCSEC = math.pi / 648000.0

# ---- Common ----------------------------------------------------------------------------------------------------------


def shortest(value, quantum):
    """The number in the fewest digits that hold it to the quantum."""
    decimals = max(0, math.ceil(-math.log10(quantum)))
    text = f"{value:.{decimals}f}".rstrip("0").rstrip(".") if decimals else f"{value:.0f}"
    if text in ("-0", ""):
        return "0"
    compact = f"{float(text):.{max(1, len(text.replace('-', '').replace('.', '').lstrip('0')))}g}"
    return min(text, compact, key=len)


def wrapped(items, width=118):
    lines, line = [], ""
    for item in items:
        if line and len(line) + len(item) + 1 > width:
            lines.append(line)
            line = ""
        line += (" " if line else "") + item
    return "\n".join(lines + [line] if line else lines)


def write(path, head, terms, counts, counts_type):
    with open(path, "w", encoding="ascii") as file:
        file.write(head)
        file.write("// clang-format off\n")
        file.write(f"constexpr {counts_type} = {counts};\n")
        file.write(terms)
        file.write("// clang-format on\n")
    print(path, os.path.getsize(path), "bytes")


def checksum(path):
    with open(path, "rb") as file:
        return hashlib.sha256(file.read()).hexdigest()


# ---- The Moon --------------------------------------------------------------------------------------------------------

MOON_SPAN_CENTURIES = 10.0  # a term in T^k counts with its amplitude at this distance from J2000
MOON_LEAST = {"L": 0.02, "B": 0.02, "R": 0.05}  # arcsec, km
MOON_QUANTUM = {"L": 1e-4, "B": 1e-4, "R": 1e-3}
MOON_FAR_CENTURIES = 80.0
MOON_POWERS = 3


def moon(source, folder):
    with open(source, encoding="utf-8") as file:
        text = file.read()
    text = re.sub(r"\b([A-Za-z]\w*):", r'"\1":', text[text.index("{") : text.rindex("}") + 1])
    theory = json.loads(re.sub(r",(\s*[\]}])", r"\1", text))
    terms, counts = [], []
    for coordinate in "LBR":
        row = []
        for power in range(MOON_POWERS):
            least = MOON_LEAST[coordinate] / MOON_SPAN_CENTURIES**power
            quantum = MOON_QUANTUM[coordinate] / MOON_FAR_CENTURIES**power
            kept = [t for t in theory[coordinate].get(str(power), []) if abs(t[0]) >= least]
            kept.sort(key=lambda t: -abs(t[0]))
            for amplitude, *phase in kept:
                phase[0] -= 0.5 * math.pi  # the source counts sines
                phase[0] = math.remainder(phase[0], 2.0 * math.pi)
                digits = [shortest(amplitude, quantum)]
                for k, p in enumerate(phase):
                    digits.append(shortest(p, quantum / abs(amplitude) / MOON_FAR_CENTURIES**k))
                while digits[-1] == "0":
                    digits.pop()
                terms.append("{" + ",".join([digits[0], "{" + ",".join(digits[1:]) + "}"]) + "},")
            row.append(str(len(kept)))
        counts.append("{" + ", ".join(row) + "}")
    head = (
        "// Made by data/make_series.py: ELP/MPP02 with the constants of DE405 (Chapront and Francou 2003, A&A 404,\n"
        f"// 735-742), {len(terms)} of its terms; source SHA-256\n// {checksum(source)}.\n"
        "// Longitude and latitude in arcsec, distance in km: {amplitude, phase polynomial in Julian centuries}, cosines.\n"
        "// Counts of terms by coordinate (longitude, latitude, distance) and power of the time that multiplies them.\n"
    )
    body = "constexpr LunarTerm moon_terms[] = {\n" + wrapped(terms) + "\n};\n"
    write(
        os.path.join(folder, "elp_mpp02_terms.inl"),
        head,
        body,
        "{" + ", ".join(counts) + "}",
        f"std::uint16_t moon_term_counts[3][{MOON_POWERS}]",
    )


# ---- The planets -----------------------------------------------------------------------------------------------------

# Name, semi-major axis in au, threshold in arcsec as seen from the Sun. Venus and Mars come near the Earth, the Sun's
# place is the Earth's.
PLANETS = [
    ("mercury", 0.39, 0.1),
    ("venus", 0.72, 0.05),
    ("earth", 1.0, 0.0015),
    ("mars", 1.52, 0.05),
    ("jupiter", 5.2, 0.1),
    ("saturn", 9.6, 0.1),
    ("uranus", 19.2, 0.1),
    ("neptune", 30.1, 0.1),
]
PLANET_SPAN_MILLENNIA = 1.0
PLANET_FAR_MILLENNIA = 8.0
PLANET_QUANTUM = 1e-9  # rad, and au for a = 1 au
PLANET_POWERS = 6


def planets(source, folder):
    terms, counts = [], []
    digest = hashlib.sha256()
    for name, axis, threshold in PLANETS:
        rows = []
        for coordinate in "LBR":
            scale = axis if coordinate == "R" else 1.0
            row = []
            for power in range(PLANET_POWERS):
                path = os.path.join(source, f"{name}.{coordinate}{power}.vsop")
                if not os.path.exists(path):
                    row.append("0")
                    continue
                with open(path, "rb") as file:
                    data = file.read()
                digest.update(data)
                series = [[float(x) for x in line.split()] for line in data.decode().splitlines() if line.strip()]
                least = threshold * ARCSEC * scale / PLANET_SPAN_MILLENNIA**power
                quantum = PLANET_QUANTUM * scale / PLANET_FAR_MILLENNIA**power
                kept = sorted((t for t in series if abs(t[0]) >= least), key=lambda t: -abs(t[0]))
                for amplitude, phase, frequency in kept:
                    share = quantum / abs(amplitude)
                    digits = [
                        shortest(amplitude, quantum),
                        shortest(phase, share),
                        shortest(frequency, share / PLANET_FAR_MILLENNIA),
                    ]
                    terms.append("{" + ",".join(digits) + "},")
                row.append(str(len(kept)))
            rows.append("{" + ", ".join(row) + "}")
        counts.append("{" + ", ".join(rows) + "}")
    head = (
        "// Made by data/make_series.py: VSOP87B (Bretagnon and Francou 1988, A&A 202, 309-315), "
        f"{len(terms)} of its terms;\n// SHA-256 of its files in order\n// {digest.hexdigest()}.\n"
        "// Longitude and latitude in rad, distance in au: {amplitude, phase, frequency per Julian millennium}, cosines.\n"
        "// Counts of terms by planet (with the Earth), coordinate and power of the time that multiplies them.\n"
    )
    body = "constexpr PlanetaryTerm planet_terms[] = {\n" + wrapped(terms) + "\n};\n"
    write(
        os.path.join(folder, "vsop87_terms.inl"),
        head,
        body,
        "{\n" + ",\n".join(counts) + "}",
        f"std::uint16_t planet_term_counts[{len(PLANETS)}][3][{PLANET_POWERS}]",
    )


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    moon(sys.argv[1], sys.argv[3])
    planets(sys.argv[2], sys.argv[3])
