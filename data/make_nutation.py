#!/usr/bin/env python3
"""Makes renderer/astro/nutation_terms.inl: the nutation theory IAU 2000A, cut short.

Usage: python3 data/make_nutation.py nut00a.c renderer/astro/nutation_terms.inl

The theory (Mathews, Herring and Buffett 2002, JGR 107, B4; IERS Conventions 2010, tables 5.3a and 5.3b) is read from the
file src/nut00a.c of ERFA 2.0.0 (Debian source package erfa), which prints its coefficients in full. Kept are the terms
that reach THRESHOLD within 60 centuries of J2000. Same input, same bytes.
"""

import hashlib
import math
import re
import sys

THRESHOLD = 2e-6  # arcsec
FAR = 60.0  # centuries
UNIT = 1e-7  # arcsec, of the file's amplitudes
ARCSEC = math.pi / 648000.0

# The arguments of the theory by powers of centuries since J2000. Luni-solar terms: l, l', F, D, Omega, arcsec.
LUNISOLAR = [
    (485868.249036, 1717915923.2178, 31.8792, 0.051635, -0.00024470),
    (1287104.79305, 129596581.0481, -0.5532, 0.000136, -0.00001149),
    (335779.526232, 1739527262.8478, -12.7512, -0.001037, 0.00000417),
    (1072260.70369, 1602961601.2090, -6.3706, 0.006593, -0.00003169),
    (450160.398036, -6962890.5431, 7.4722, 0.007702, -0.00005939),
]
# Planetary terms: l, F, D, Omega, Mercury to Neptune, general precession in longitude, rad.
PLANETARY = [
    (2.35555598, 8328.6914269554, 0.0),
    (1.627905234, 8433.466158131, 0.0),
    (5.198466741, 7771.3771468121, 0.0),
    (2.18243920, -33.757045, 0.0),
    (4.402608842, 2608.7903141574, 0.0),
    (3.176146697, 1021.3285546211, 0.0),
    (1.753470314, 628.3075849991, 0.0),
    (6.203480913, 334.0612426700, 0.0),
    (0.599546497, 52.9690962641, 0.0),
    (0.874016757, 21.3299104960, 0.0),
    (5.481293872, 7.4781598567, 0.0),
    (5.321159000, 3.8127774000, 0.0),
    (0.0, 0.024381750, 0.00000538691),
]


def rows(source, name, length):
    """The rows of numbers of the array `name`."""
    body = re.search(name + r"\[\] = \{(.*?)\n   \};", source, re.S).group(1)
    body = re.sub(r"/\*.*?\*/", "", body, flags=re.S)
    found = [[float(x) for x in row.split(",")] for row in re.findall(r"\{([^{}]*)\}", body)]
    if not found or any(len(row) != length for row in found):
        sys.exit(f"{name}: rows of {length} numbers expected")
    return found


def phase(multipliers, arguments, unit):
    powers = [sum(m * a[k] for m, a in zip(multipliers, arguments)) * unit for k in range(len(arguments[0]))]
    powers[0] = math.remainder(powers[0], 2.0 * math.pi)
    return powers + [0.0] * (5 - len(powers))


def number(value):
    text = f"{value:.15g}"
    return "0" if text == "-0" else text


def main():
    with open(sys.argv[1], "rb") as file:
        raw = file.read()
    source = raw.decode("latin-1")
    terms = []
    for row in rows(source, "xls", 11):
        sp, spt, cp, ce, cet, se = (x * UNIT for x in row[5:])
        terms.append((phase(row[:5], LUNISOLAR, ARCSEC), (sp, spt, cp, ce, cet, se)))
    for row in rows(source, "xpl", 17):
        sp, cp, se, ce = (x * UNIT for x in row[13:])
        terms.append((phase(row[:13], PLANETARY, 1.0), (sp, 0.0, cp, ce, 0.0, se)))

    def size(term):
        sp, spt, cp, ce, cet, se = term[1]
        return max(math.hypot(abs(sp) + FAR * abs(spt), cp), math.hypot(abs(ce) + FAR * abs(cet), se))

    kept = sorted((t for t in terms if size(t) >= THRESHOLD), key=size, reverse=True)
    dropped = sum(size(t) for t in terms) - sum(size(t) for t in kept)
    with open(sys.argv[2], "w", encoding="ascii") as file:
        file.write(
            "// Made by data/make_nutation.py: IAU 2000A (Mathews, Herring and Buffett 2002, JGR 107, B4), "
            f"{len(kept)} of its {len(terms)}\n// terms; SHA-256 of their file\n"
            f"// {hashlib.sha256(raw).hexdigest()}.\n"
            "// {phase, rad, by powers of centuries}, in longitude sine, sine times t, cosine, in obliquity cosine, "
            "cosine times t,\n// sine, arcsec.\n// clang-format off\n"
            "constexpr NutationTerm nutation_terms[] = {\n"
        )
        file.write(
            ",\n".join(
                "{{" + ",".join(map(number, p)) + "}," + ",".join(map(number, a)) + "}" for p, a in kept
            )
        )
        file.write("};\n// clang-format on\n")
    print(f"{len(kept)} terms; the others add up to {dropped:.5f} arcsec at most")


main()
