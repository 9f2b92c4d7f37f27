"""The model in mpmath, to as many digits as are asked for: what ``contact.c`` is held against.

Integrals by ``mpmath.quad``, moments of sizes in closed form.  Choices are those at the head of it.
"""

from mpmath import erfc, exp, inf, log, mp, mpf, pi, quad, sqrt


class Interface:
    """One point: ``given`` has the conditions, the numbers and the interpretations of its model."""

    def __init__(self, given):
        self.given = {k: v if isinstance(v, str) else mpf(v) for k, v in given.items()}
        self.__dict__.update({k: v for k, v in self.given.items() if not isinstance(v, str)})
        self.two_body = self.particle_diameter == 0 or self.particle_density == 0
        self.plane = self.y_s if given["particle_plane"] == "summit" else mpf(0)
        x_a = self.particle_diameter
        self.spread = self.sigma_a_ratio * x_a
        self.mean = self.mean_ratio * x_a
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
        low, high = max(low, mpf(0)), min(high, self.x_max)
        if low >= high:
            return mpf(0)
        m, s = self.mean, self.spread
        a, b = (low - m) / s, (high - m) / s
        with mp.extradps(40 + int(min(b * b, 2000) / 4)):  # what the differences cancel
            share = (erfc(a / sqrt(2)) - erfc(b / sqrt(2))) / 2
            tails = (2 * m + s * a) * gaussian(a) - (2 * m + s * b) * gaussian(b)
            return (m * m + s * s) * share + s * tails

    def particles(self, h):
        """A_sa*."""
        if self.two_body:
            return mpf(0)
        d = h - self.plane
        weight = 9 * pi**2 / 4 * ((self.H_s1 / self.E_sa) ** 2 + (self.H_s2 / self.E_ss) ** 2)
        moment = weight * self.moment(d - self.h_e, d) + self.moment(d, inf)
        return pi * self.H_s2 / (self.H_s1 + self.H_s2) * self.loaded() * moment

    def loaded(self):
        return self.participation * self.particle_density

    def coverage(self, low):
        if self.two_body:
            return mpf(0)
        return pi * self.H_s1 / (self.H_s1 + self.H_s2) * self.loaded() * self.moment(low, inf)

    def solid_load(self, h):
        """F_s*."""
        particles = self.H_s1 / self.E_ss * self.particles(h)
        return self.summits(h, of_area=False) * (1 - self.coverage(0)) + particles

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

    # --- what must hold ---

    def near_kink(self, h):
        """Whether the largest particles begin to touch or to yield within a millionth of ``h``."""
        kinks = [self.plane + self.x_max + i * self.h_e for i in (0, 1)]
        return any(abs(h - kink) < h * mpf("1e-6") for kink in kinks)

    def at(self, h, fluid):
        """The load, the film's thickness and the areas at the separation ``h``, where the film
        bears ``fluid``."""
        total = self.given["film_load"] == "total"
        film = self.film(self.load if total else fluid) if self.viscosity and fluid else h
        particles = self.particles(h)
        summits = self.summits(h, of_area=True) * (1 - self.coverage(h - self.plane))
        return {
            "load": self.solid_load(h) + fluid,
            "separation": film,
            "total_contact_area": summits + particles,
            "particle_contact_area_ratio": particles / (summits + particles),
            "surface_contact_area_ratio": summits / (summits + particles),
        }


def gaussian(u):
    return exp(-u * u / 2) / sqrt(2 * pi)
