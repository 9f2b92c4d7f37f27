"""Oils of the explorer: kinematic viscosities [cSt] at 40 and 100 C by ISO grade (ISO 3448).

The viscosities at 100 C have a viscosity index of 95 (ASTM D2270), as mineral oils in ISO 3448.
"""

OILS = {
    7: (6.8, 2.06474),
    10: (10.0, 2.63709),
    15: (15.0, 3.38126),
    22: (22.0, 4.2537),
    32: (32.0, 5.2896),
    46: (46.0, 6.64392),
    68: (68.0, 8.52988),
    100: (100.0, 11.067),
    150: (150.0, 14.5441),
    220: (220.0, 18.7493),
    320: (320.0, 23.9519),
    460: (460.0, 30.3399),
    680: (680.0, 39.0563),
    1000: (1000.0, 49.8633),
    1500: (1500.0, 64.2127),
    2200: (2200.0, 81.1782),
    3200: (3200.0, 101.639),
}
TEMPERATURES = -70.0, 370.0  # the range of ASTM D341 [C]
VISCOSITIES = 2.0, 2e7  # the range in which ASTM D341 is a line with the constant 0.7 [cSt]
