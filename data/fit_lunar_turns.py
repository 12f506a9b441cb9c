#!/usr/bin/env python3
"""Small turns of the Moon's mean-Earth axes that the IAU series leaves out, by least squares on JPL DE405.

Prints, for each argument, the cosine and sine amplitudes (arcsec) about x, y and z: the source of `turns` in
renderer/astro/lunar_orientation.cpp. Reads the file table.f0i of Debian's casacore-data-jpl-de405: after 28 bytes, one
record of 1016 little-endian doubles for each 32 days from JD 2436912.5, 8160 bytes apart, with the Moon's Euler angles
from the 897th on (4 granules of 10 Chebyshev coefficients for phi, theta, psi).

    python3 data/fit_lunar_turns.py /usr/share/casacore/data/ephemerides/DE405/table.f0i
"""

import math
import struct
import sys

FIRST_JD, RECORDS, DAYS = 2436912.5, 1143, 32.0
J2000 = 2451545.0
ARCSEC = math.pi / 648000.0

# The IAU series (Archinal et al. 2011): argument, its rate a day, what it adds to pole and meridian, degrees.
IAU = [
    (125.045, -0.0529921, -3.8787, 1.5419, 3.5610), (250.089, -0.1059842, -0.1204, 0.0239, 0.1208),
    (260.008, 13.0120009, 0.0700, -0.0278, -0.0642), (176.625, 13.3407154, -0.0172, 0.0068, 0.0158),
    (357.529, 0.9856003, 0.0, 0.0, 0.0252), (311.589, 26.4057084, 0.0072, -0.0029, -0.0066),
    (134.963, 13.0649930, 0.0, 0.0009, -0.0047), (276.617, 0.3287146, 0.0, 0.0, -0.0046),
    (34.226, 1.7484877, 0.0, 0.0, 0.0028), (15.134, -0.1589763, -0.0052, 0.0008, 0.0052),
    (119.743, 0.0036096, 0.0, 0.0, 0.0040), (239.961, 0.1643573, 0.0, 0.0, 0.0019),
    (25.053, 12.9590088, 0.0043, -0.0009, -0.0044)]

# Delaunay's arguments and rates (IERS Conventions 2003), degrees and degrees a day.
L, F, D, NODE = ((134.96340251, 13.064992953), (93.27209062, 13.229350240), (297.85019547, 12.190749114),
                 (125.04455501, -0.052953765))


def argument(l=0, f=0, d=0, node=0):
    return tuple(l * L[i] + f * F[i] + d * D[i] + node * NODE[i] for i in (0, 1))


ARGUMENTS = {
    "wobble": (0.0, 360.0 / (74.626 * 365.25)), "free libration": (0.0, 360.0 / 1056.13),
    "2D-F": argument(d=2, f=-1), "l+F-2D": argument(l=1, f=1, d=-2), "l+F": argument(l=1, f=1), "F": argument(f=1),
    "l": argument(l=1), "2 node": argument(node=2), "node": argument(node=1), "2D-l": argument(d=2, l=-1),
    "l-D": argument(l=1, d=-1), "2F-2D": argument(f=2, d=-2), "2D": argument(d=2), "2l": argument(l=2)}


def turned(axis, angle):
    c, s = math.cos(angle), math.sin(angle)
    return {"x": [[1, 0, 0], [0, c, s], [0, -s, c]], "y": [[c, 0, -s], [0, 1, 0], [s, 0, c]],
            "z": [[c, s, 0], [-s, c, 0], [0, 0, 1]]}[axis]


def product(a, *others):
    for b in others:
        a = [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]
    return a


def series(days):
    ra, dec = 269.9949 + 0.0031 * days / 36525.0, 66.5392 + 0.0130 * days / 36525.0
    meridian = 38.3213 + 13.17635815 * days - 1.4e-12 * days * days
    for start, rate, ra_sin, dec_cos, meridian_sin in IAU:
        e = math.radians(start + rate * days)
        ra, dec, meridian = ra + ra_sin * math.sin(e), dec + dec_cos * math.cos(e), meridian + meridian_sin * math.sin(e)
    return product(turned("z", math.radians(meridian)), turned("x", math.radians(90.0 - dec)),
                   turned("z", math.radians(90.0 + ra)))


def integrated(data, jd):
    record = min(int((jd - FIRST_JD) // DAYS), RECORDS - 1)
    since = jd - FIRST_JD - DAYS * record
    granule = min(int(since // 8.0), 3)
    x = 2.0 * (since - 8.0 * granule) / 8.0 - 1.0
    angles = []
    for component in range(3):
        at = 28 + 8160 * record + 8 * (896 + (granule * 3 + component) * 10)
        b0 = b1 = 0.0
        coefficients = struct.unpack("<10d", data[at:at + 80])
        for c in reversed(coefficients[1:]):
            b0, b1 = 2.0 * x * b0 - b1 + c, b0
        angles.append(x * b0 - b1 + coefficients[0])
    phi, theta, psi = angles
    return product(turned("x", -0.1462 * ARCSEC), turned("y", -79.0768 * ARCSEC), turned("z", -63.8986 * ARCSEC),
                   turned("z", psi), turned("x", theta), turned("z", phi))


def solve(matrix, right):
    rows = [row + [value] for row, value in zip(matrix, right)]
    n = len(rows)
    for i in range(n):
        pivot = max(range(i, n), key=lambda r: abs(rows[r][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for r in range(n):
            if r != i:
                factor = rows[r][i] / rows[i][i]
                rows[r] = [a - factor * b for a, b in zip(rows[r], rows[i])]
    return [rows[i][n] / rows[i][i] for i in range(n)]


def main():
    data = open(sys.argv[1], "rb").read()
    samples = 4096
    design, turns = [], []
    for k in range(samples):
        days = FIRST_JD + DAYS * RECORDS * (k + 0.5) / samples - J2000
        a, b = series(days), integrated(data, days + J2000)
        m = [[sum(a[i][c] * b[j][c] for c in range(3)) for j in range(3)] for i in range(3)]
        turns.append([(m[1][2] - m[2][1]) / 2 / ARCSEC, (m[2][0] - m[0][2]) / 2 / ARCSEC,
                      (m[0][1] - m[1][0]) / 2 / ARCSEC])
        row = [1.0]
        for start, rate in ARGUMENTS.values():
            row += [math.cos(math.radians(start + rate * days)), math.sin(math.radians(start + rate * days))]
        design.append(row)
    n = len(design[0])
    normal = [[sum(row[i] * row[j] for row in design) for j in range(n)] for i in range(n)]
    for axis in range(3):
        found = solve(normal, [sum(row[i] * turn[axis] for row, turn in zip(design, turns)) for i in range(n)])
        left = [turn[axis] - sum(p * q for p, q in zip(row, found)) for row, turn in zip(design, turns)]
        print("%s: constant %.2f, left over worst %.2f rms %.2f" %
              ("xyz"[axis], found[0], max(map(abs, left)), math.sqrt(sum(e * e for e in left) / samples)))
        for i, name in enumerate(ARGUMENTS):
            print("  %-15s cos %6.2f  sin %6.2f" % (name, found[1 + 2 * i], found[2 + 2 * i]))


if __name__ == "__main__":
    main()
