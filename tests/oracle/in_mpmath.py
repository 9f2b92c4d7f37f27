"""The model in mpmath, to as many digits as are asked for: what ``contact.c`` is held against.

Integrals by ``mpmath.quad``, moments of sizes in closed form, the root by secants from where
``contact.c`` found it.  Choices are those at the head of it.
"""

from mpmath import erfc, exp, findroot, inf, log, mp, mpf, pi, quad, sqrt

FIRST_GUESS = mpf("1e-17")  # how far off the separation that is started from may be


class Interface:
    """One point: ``given`` has the conditions, the numbers and the interpretations of its model."""

    def __init__(self, given):
        self.given = {k: v if isinstance(v, str) else mpf(v) for k, v in given.items()}
        self.__dict__.update({k: v for k, v in self.given.items() if not isinstance(v, str)})
        self.two_body = self.particle_diameter == 0 or self.particle_density == 0
        self.plane = self.y_s if given["particle_plane"] == "summit" else mpf(0)
        x_a = self.particle_diameter
        self.spread = self.sigma_a_ratio * x_a
        self.mean = mpf(0) if given["phi_a"] == "uncentred" else self.mean_ratio * x_a
        if given["phi_a"] == "gap_convolved":
            self.spread = sqrt(self.spread**2 + (self.gap_ratio * self.roughness) ** 2)
        self.x_max = self.mean + self.truncation * self.spread
        self.h_e = self.h_e_ratio * x_a

    # --- summits ---

    def summits(self, h, of_area):
        """A_ss* or F_ss*, were there no particles."""
        hardness = min(self.H_s1, self.H_s2)
        first = (3 * pi * self.k * hardness / (4 * self.E_ss)) ** 2 * self.R
        last = self.omega_ratio * first
        d = (h - self.y_s) / self.sigma_s

        top = max(d, mpf(0))  # mpmath's quad knows absolute errors only: all is of the order of 1

        def area(omega):
            u = (omega - first) / (last - first) if first < omega < last else 0
            factor = 2 if omega >= last else 1 - 2 * u**3 + 3 * u**2
            return pi * self.R * omega * factor

        def load(omega):
            if omega <= first:
                return 4 * sqrt(self.R) * omega * sqrt(omega) / 3
            if omega >= last:
                return area(omega) * hardness / self.E_ss
            ahead = (log(last) - log(omega)) / (log(last) - log(first))
            return area(omega) * hardness / self.E_ss * (1 - (1 - self.k) * ahead)

        def integrand(r):
            single = (area if of_area else load)(r * r * self.sigma_s) / scale
            return 2 * r * single * exp((top - d - r * r) * (top + d + r * r) / 2)

        end = 16 * 16 / (sqrt(top**2 + 256) + top) - min(d, mpf(0))
        scale = (area if of_area else load)(self.sigma_s / (1 + top)) / (1 + top)
        inner = [first / self.sigma_s, last / self.sigma_s, -d, end / 8, end / 3, end / 2]
        inner += [first / self.sigma_s * mpf(4) ** i for i in range(1, 7)]
        edges = [sqrt(w) for w in sorted({mpf(0), *(w for w in inner if 0 < w < end), end})]
        integral = scale * quad(integrand, edges, method="gauss-legendre")
        return self.eta_s * integral * gaussian(top)

    # --- particles ---

    def moment(self, low, high):
        """I(low, high)."""
        high = min(high, self.x_max)
        gap = self.given["phi_a"] == "gap_convolved"
        low = low if gap else max(low, mpf(0))
        if low >= high:
            return mpf(0)
        m, s = self.mean, self.spread
        a, b = (low - m) / s, (high - m) / s
        with mp.extradps(40 + int(min(b * b, 2000) / 4)):  # what the differences cancel
            share = (erfc(a / sqrt(2)) - erfc(b / sqrt(2))) / 2
            if gap:
                return (1 + self.sigma_a_ratio**2) * self.particle_diameter**2 * share
            tails = (2 * m + s * a) * gaussian(a) if a > -inf else 0
            return (m * m + s * s) * share + s * (tails - (2 * m + s * b) * gaussian(b))

    def particles(self, h):
        """A_sa*."""
        if self.two_body:
            return mpf(0)
        d = h - self.plane
        first, second = (d - self.h_e, d)
        if self.given["elastic_limits"] == "physical":
            first, second = (d, d + self.h_e)
        weight = 9 * pi**2 / 4 * ((self.H_s1 / self.E_sa) ** 2 + (self.H_s2 / self.E_ss) ** 2)
        moment = weight * self.moment(first, second) + self.moment(second, inf)
        return pi * self.H_s2 / (self.H_s1 + self.H_s2) * self.loaded() * moment

    def loaded(self):
        return self.participation * self.particle_density

    def coverage(self, low):
        if self.two_body:
            return mpf(0)
        return pi * self.H_s1 / (self.H_s1 + self.H_s2) * self.loaded() * self.moment(low, inf)

    def solid_load(self, h):
        """F_s*."""
        contacting = self.given["coverage_limits"] == "contacting"
        covered = self.coverage(h - self.plane if contacting else -inf)
        particles = self.H_s1 / self.E_ss * self.particles(h)
        return self.summits(h, of_area=False) * (1 - covered) + particles

    # --- film ---

    def film(self, load):
        """h of the film under the load F*."""
        w = load * self.A_n / self.R_x**2
        u, g, kappa = self.U_per_viscosity * self.viscosity, self.G, self.kappa
        smooth = mpf("3.672") * w ** (mpf("-0.045") * kappa ** mpf("0.18"))
        smooth *= u ** (mpf("0.663") * kappa ** mpf("0.025"))
        smooth *= g ** (mpf("0.502") * kappa ** mpf("0.064"))
        smooth *= 1 - mpf("0.573") * exp(mpf("-0.74") * kappa)
        rough = mpf("0.025") * (self.roughness / self.R_x) ** mpf("1.248") * self.V ** mpf("0.119")
        rough *= w ** mpf("-0.133") * u ** mpf("-0.884") * g ** mpf("-0.977")
        return self.R_x * smooth * (1 + rough * kappa ** mpf("0.081"))

    def fluid_load(self, h):
        """F_f* of the film of thickness h."""
        x = log(self.load)
        for _ in range(200):
            step = mpf("1e-20")
            value = log(self.film(exp(x)) / h)
            slope = (log(self.film(exp(x + step)) / h) - value) / step
            x -= value / slope
            if abs(value / slope) < mpf(10) ** (8 - mp.dps):
                return exp(x)
        raise ArithmeticError("no load gives this film")

    # --- balance ---

    def root(self, start):
        """The separation next to ``start`` that balances the forces, and the fluid's load there."""
        if self.given["film_load"] == "total" and self.viscosity > 0:
            alone = self.film(self.load)
            if abs(start - alone) < abs(start) * mpf("1e-15"):
                return alone, self.load - self.solid_load(alone)
        wet = self.given["film_load"] == "fluid" and self.viscosity > 0

        def excess(h):
            return log((self.solid_load(h) + (self.fluid_load(h) if wet else 0)) / self.load)

        kinks = [self.plane + self.x_max + i * self.h_e for i in (-1, 0, 1)]
        kink = min(kinks, key=lambda one: abs(start - one))
        if abs(start - kink) > abs(start) * mpf("1e-6"):
            h = by_secants(excess, start, start * (1 + FIRST_GUESS))
        else:  # of the distance to the kink, ``start`` holds few digits
            h = self.near(kink, excess, start)
        return h, self.fluid_load(h) if wet else mpf(0)

    def near(self, kink, excess, start):
        """The root whose distance to ``kink`` may be much smaller than the last digit of both."""
        side = -1 if excess(kink) < 0 else 1  # forces fall as the separation grows
        far = 2 * abs(start - kink) + abs(kink) * mpf("1e-18")
        close = abs(kink) * mpf(10) ** (25 - mp.dps)
        if excess(kink + side * close) * side < 0 or excess(kink + side * far) * side > 0:
            raise ArithmeticError("the root is nearer to a kink than the digits tell")
        logarithm = findroot(
            lambda x: excess(kink + side * exp(x)), (log(close), log(far)), solver="anderson"
        )
        return kink + side * exp(logarithm)

    def quantities(self, start):
        """The quantities of ``extended.QUANTITIES`` by name."""
        h, fluid = self.root(start)
        particles = self.particles(h)
        summits = self.summits(h, of_area=True) * (1 - self.coverage(h - self.plane))
        solid = self.solid_load(h) if fluid else self.load
        return {
            "separation": h,
            "solid_load_fraction": solid / self.load,
            "fluid_load_fraction": fluid / self.load,
            "total_contact_area": summits + particles,
            "particle_contact_area_ratio": particles / (summits + particles),
            "surface_contact_area_ratio": summits / (summits + particles),
            "film_thickness": h / self.R_x,
        }


def by_secants(function, a, b):
    """The root of ``function`` close to ``a`` and ``b``."""
    f, g = function(a), function(b)
    for _ in range(40):
        if g == f or abs(b - a) < abs(b) * mpf(10) ** (12 - mp.dps):
            break
        a, b = b, b - g * (b - a) / (g - f)
        f, g = g, function(b)
    return b


def gaussian(u):
    return exp(-u * u / 2) / sqrt(2 * pi)
