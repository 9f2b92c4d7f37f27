/* The model of Chen & Horng (2024) in long double: the separation that balances the forces.
 *
 * For tests alone.  Written from the paper (equation numbers are its own).  Integrals are sums
 * over panels that end at every kink; nothing is tabulated, nothing is carried from point to point.
 * Lengths in m, forces over A_n E_ss, areas over A_n.  Long double has 64 bits and exponents of
 * +-16383 (x86), so that tails of 40 standard deviations, exp(-800), need no logarithms.
 *
 * Where the print leaves a choice.  The sentences of the paper are in quotation marks; names in
 * backticks are keys of the attribute `model_parameters` of a dataset.
 *
 * 1.  Which separation.  "d is mean separation between two surfaces", and Section 2.3 takes it from
 *     the film, h = R_x H_c; but the two-body model of Zhao et al. (2000) measures d from the plane
 *     of the summits, which lies y_s above that of the surface.  Here h is the separation of the
 *     surfaces, and is what is reported; summits always see h - y_s; particles see h, or h - y_s
 *     where `particle_plane` is "summit".
 * 2.  Hardness of summits.  "F_ss and A_ss are calculated according to the previous 2-body contact
 *     model (Zhao et al., 2000)", which has one hardness, while Table 1 has two.  It is taken to be
 *     that of the softer surface, min(H_s1, H_s2): where two surfaces touch the softer one yields,
 *     and where the paper itself needs one hardness of the pair it takes "the Vickers hardness of
 *     softer material" (below Eq. 8).  In Table 1 both are 5.0 GPa.
 * 3.  Sizes.  Eq. 6 prints phi_a without a mean, while Table 2 calls x_a the "mean particle
 *     diameter".  Their mean is `mean_ratio` x_a: 0 as printed, 1 as the table has it.
 * 4.  Truncation.  "x_max is maximum particle size": X_max = mean + `truncation` times the spread of
 *     sizes.  The density is that of Eq. 6, not divided by what truncation leaves of it.
 * 5.  Smallest size.  "x_min is minimum particle size", of which no value is given: zero.  No integral
 *     reaches below it, also where d < h_e.
 * 6.  Elastic particles.  As printed in Eqs. 4 and 5: elastic in (d - h_e, d) and plastic in (d, X_max),
 *     though a particle of diameter below d touches only one surface.
 * 7.  h_e, "maximum separation of two surfaces with particles that lead to plastic contact", has no
 *     value: it is `h_e_ratio` x_a, the same for all sizes of one mixture.
 * 8.  Coverage.  As printed: Eq. 4 takes from F_ss the share that particles of all sizes cover (X_min to
 *     X_max), Eq. 5 takes from A_ss the share of those that touch (d to X_max).  Where the share exceeds 1
 *     the equation has no meaning, and no value is given.
 * 9.  Participation.  "eta_a is particle density" per area of interface; `participation` is the
 *     fraction of them that bears load.  The others do not touch, so they cover nothing either:
 *     it multiplies eta_a wherever that stands.  The print means 1.
 * 10. Load of the film.  Eq. 8 prints W = F_t/(E_ss R_x^2), but the paper's own film thicknesses join
 *     the dry curve only if the fluid's share is meant.  `film_load`: "fluid" puts F_f into W,
 *     "total" F_t.  A film under the total load holds its thickness whatever it bears: it takes
 *     what the solids leave, and nothing where they hold the surfaces farther apart.
 * 11. Area ratios.  "A_ss,t* = A_ss/A_t" (Eq. 10) adds up to 1 with A_sa,t* only if A_ss means what
 *     particles leave of it, the A_ss-sa of Eq. 5.
 * 12. One separation.  The elastic factor must be at most 1, for hard particles: then F_s falls as the
 *     surfaces part, and Eq. 1 holds at one separation at most.
 */
#include <math.h>

typedef long double real;

enum { NODES = 24 };
enum { ELASTIC, ELASTOPLASTIC, PLASTIC };
enum { LOAD, AREA };

static const real PI = 3.141592653589793238462643383279502884L;
static const real REACH = 10.5L; /* exp(-REACH^2/2) = 1e-24 of an integrand's largest value */
static const real NOTHING = -1e9L; /* ln of no force at all */

/* One point: the order in which extended.py hands the numbers over. */
typedef struct {
    double load, viscosity, diameter, roughness, density;
    double eta_s, R, sigma_s, y_s;
    double E_ss, E_sa, H_s1, H_s2, k, omega_ratio;
    double R_x, G, V, kappa, U_per_viscosity, A_n;
    double mean_ratio, sigma_a_ratio, truncation, participation, h_e_ratio;
} Numbers;

typedef struct {
    int summit; /* particle_plane: 1 = summit */
    int total;  /* film_load */
} Interpretations;

typedef struct {
    real separation, solid_fraction, fluid_fraction, area, particle_ratio, summit_ratio, film;
} Root;

typedef struct {
    Numbers in;
    Interpretations how;
    int two_body, dry;
    real hardness, first, last, log_ratio; /* of summits; omega_1, omega_2 over sigma_s */
    real mean, spread, x_max, h_e; /* of sizes */
    real elastic_factor, plane, coverage_by_all;
    real film_smooth, film_rough, power, rough_power; /* h = smooth F^-a (1 + rough F^-b) */
    real alone;                          /* h of the film that bears all of the load */
} Point;

/* A separation h of the surfaces.  Near the kinks of F_s, where the largest particles X_max lose
 * touch, their load depends on X_max - d, of which h itself would leave few digits: there
 * d = X_max + steps h_e + offset.  Elsewhere h = offset. */
typedef struct {
    int near_kink, steps;
    real offset;
} Gap;

/* --- Gauss-Legendre nodes --- */

static real node[NODES], weight[NODES];

void prepare(void)
{
    for (int i = 0; i < NODES; i++) {
        real x = cosl(PI * (i + 0.75L) / (NODES + 0.5L)), slope = 1;
        for (int step = 0; step < 60; step++) {
            real before = 1, now = x;
            for (int n = 2; n <= NODES; n++) {
                real next = ((2 * n - 1) * x * now - (n - 1) * before) / n;
                before = now;
                now = next;
            }
            slope = NODES * (x * now - before) / (x * x - 1);
            x -= now / slope;
        }
        node[i] = x;
        weight[i] = 2 / ((1 - x * x) * slope * slope);
    }
}

/* --- Integrals over a Gaussian --- */

typedef real (*Function)(real w, const void *what);

static real gaussian(real u)
{
    return 0.398942280401432677939946059934381868L * expl(-0.5L * u * u);
}

/* Where a panel that begins at u (and w) has to end: the exponential may not change too much, and
 * a logarithm of w must be far from its singularity at w = 0. */
static real panel_length(real u, real w, int logarithmic)
{
    real length = fminl(3, 16 / (fabsl(u) + 1));
    return logarithmic ? fminl(length, 15 * w) : length;
}

/* Integrals over w, from 0 to ``length``, of function(w) times the Gaussian of u = low + w.  Where
 * w is small at the Gaussian, w = r^2 makes its powers of 3/2 smooth; where it is large (low far
 * below zero), it would cost the digits of u, and u itself is the variable. */
typedef struct {
    real low, from, to; /* what counts, in w or in u: the rest is below 1e-24 */
    int in_u;
} Range;

static Range range_of(real low, real length)
{
    real top = low >= 0 ? low : fminl(0, low + length); /* u where the Gaussian is largest */
    real reach = REACH * REACH / (hypotl(top, REACH) + fabsl(top));
    if (low <= -REACH)
        return (Range){low, fmaxl(low, top - reach), fminl(low + length, top + reach), 1};
    real peak = fminl(fmaxl(0, -low), length);
    return (Range){low, fmaxl(0, peak - reach), fminl(length, peak + reach), 0};
}

static real panels(Function function, const void *what, Range range, int logarithmic)
{
    real total = 0, low = range.low;
    if (range.in_u)
        for (real u = range.from; u < range.to;) {
            real end = fminl(range.to, u + panel_length(u, u - low, logarithmic));
            real half = 0.5L * (end - u), sum = 0;
            for (int i = 0; i < NODES; i++) {
                real v = u + half * (1 + node[i]);
                sum += weight[i] * function(v - low, what) * gaussian(v);
            }
            total += half * sum;
            u = end;
        }
    else
        for (real w = range.from; w < range.to;) {
            real end = fminl(range.to, w + panel_length(low + w, w, logarithmic));
            real a = sqrtl(w), half = 0.5L * (sqrtl(end) - a), sum = 0;
            for (int i = 0; i < NODES; i++) {
                real r = a + half * (1 + node[i]);
                sum += weight[i] * 2 * r * function(r * r, what) * gaussian(low + r * r);
            }
            total += half * sum;
            w = end;
        }
    return total;
}

/* --- Summits: Zhao, Maietta & Chang (2000) --- */

typedef struct {
    const Point *p;
    int law, what; /* LOAD or AREA */
} Summit;

/* Area over R sigma_s, or load over E_ss R sigma_s, of a summit at interference w sigma_s. */
static real one_summit(real w, const void *what)
{
    const Summit *s = what;
    const Point *p = s->p;
    real area = PI * w;
    if (s->law == ELASTIC)
        return s->what == AREA ? area : 4 * w * sqrtl(w * p->in.sigma_s / p->in.R) / 3;
    real pressure = p->hardness / p->in.E_ss;
    if (s->law == PLASTIC) {
        area *= 2;
    } else {
        real u = (w - p->first) / (p->last - p->first);
        area *= 1 + u * u * (3 - 2 * u);
        if (s->what == LOAD)
            pressure *= 1 - (1 - (real)p->in.k) * logl(p->last / w) / p->log_ratio;
    }
    return s->what == AREA ? area : area * pressure;
}

static real separation(const Point *p, Gap gap)
{
    return gap.near_kink ? p->plane + p->x_max + gap.steps * p->h_e + gap.offset : gap.offset;
}

/* F_ss* or A_ss*, were there no particles. */
static real summits(const Point *p, Gap gap, int what)
{
    real low = (separation(p, gap) - p->in.y_s) / p->in.sigma_s, total = 0;
    Range all = range_of(low, INFINITY);
    real edges[4] = {0, p->first, p->last, INFINITY};
    for (int law = ELASTIC; law <= PLASTIC; law++) {
        Summit s = {p, law, what};
        Range part = all;
        part.from = fmaxl(part.from, edges[law] + (all.in_u ? low : 0));
        part.to = fminl(part.to, edges[law + 1] + (all.in_u ? low : 0));
        total += panels(one_summit, &s, part, law == ELASTOPLASTIC && what != AREA);
    }
    return total * p->in.eta_s * p->in.R * p->in.sigma_s;
}

/* --- Particles: Eqs. 4 to 6 --- */

typedef struct {
    const Point *p;
    real low;
} Sizes;

static real squared_size(real w, const void *what)
{
    const Sizes *s = what;
    real x = s->low + w * s->p->spread;
    return x * x;
}

/* X_max - (d + steps h_e): how far below the largest size a limit of Eqs. 4 and 5 is. */
static real below_largest(const Point *p, Gap gap, int steps)
{
    if (gap.near_kink)
        return -gap.offset - (gap.steps + steps) * p->h_e;
    return p->x_max - (gap.offset - p->plane) - steps * p->h_e;
}

/* I(a, b), the integral of x^2 phi_a(x) from a = X_max - ``from`` to b = X_max - ``to``. */
static real moment(const Point *p, real from, real to)
{
    from = fminl(from, p->x_max - fmaxl(0, p->mean - 200 * p->spread));
    to = fmaxl(to, 0);
    if (!(from > to))
        return 0;
    Sizes sizes = {p, p->x_max - from};
    real low = (sizes.low - p->mean) / p->spread;
    return panels(squared_size, &sizes, range_of(low, (from - to) / p->spread), 0);
}

static real loaded_density(const Point *p)
{
    return PI * p->in.participation * p->in.density / ((real)p->in.H_s1 + p->in.H_s2);
}

/* A_sa*, Eq. 5; F_sa* is H_s1/E_ss of it (Eq. 4). */
static real particles(const Point *p, Gap gap)
{
    real d = below_largest(p, gap, 0);
    return p->two_body ? 0 : loaded_density(p) * p->in.H_s2
                             * (p->elastic_factor * moment(p, below_largest(p, gap, -1), d) + moment(p, d, 0));
}

static real particle_load(const Point *p, Gap gap)
{
    return p->in.H_s1 / (real)p->in.E_ss * particles(p, gap);
}

/* What Eq. 5 takes from 1. */
static real touching_coverage(const Point *p, Gap gap)
{
    return p->two_body ? 0 : loaded_density(p) * p->in.H_s1 * moment(p, below_largest(p, gap, 0), 0);
}

/* F_s*, Eq. 4. */
static real solids(const Point *p, Gap gap)
{
    return summits(p, gap, LOAD) * fmaxl(0, 1 - p->coverage_by_all) + particle_load(p, gap);
}

/* --- Film: Eqs. 7 and 8 --- */

static void set_film(Point *p)
{
    const Numbers *n = &p->in;
    real per_load = (real)n->A_n / n->R_x / n->R_x; /* W over F* */
    real U = (real)n->U_per_viscosity * n->viscosity, G = n->G, kappa = n->kappa;
    p->power = 0.045L * powl(kappa, 0.18L);
    p->rough_power = 0.133L;
    p->film_smooth = n->R_x * 3.672L * powl(per_load, -p->power) * powl(U, 0.663L * powl(kappa, 0.025L))
                     * powl(G, 0.502L * powl(kappa, 0.064L)) * (1 - 0.573L * expl(-0.74L * kappa));
    p->film_rough = 0.025L * powl((real)n->roughness / n->R_x, 1.248L) * powl(n->V, 0.119L)
                    * powl(per_load, -0.133L) * powl(U, -0.884L) * powl(G, -0.977L)
                    * powl(kappa, 0.081L);
}

/* h = R_x H_c under the load F*. */
static real film(const Point *p, real load)
{
    return p->film_smooth * powl(load, -p->power)
           * (1 + p->film_rough * powl(load, -p->rough_power));
}

/* F_f* of a film of thickness h: Newton's method in x = ln F* from below, where ln h is convex. */
static real film_load(const Point *p, real h)
{
    real target = logl(p->film_smooth / h), a = p->power, b = p->rough_power, r = 0;
    real x = fmaxl(target / a, (target + logl(p->film_rough)) / (a + b));
    for (int step = 0; step < 100; step++) {
        r = p->film_rough * expl(-b * x);
        real move = (target - a * x + log1pl(r)) / (a + b * r / (1 + r));
        x += move;
        if (fabsl(move) < 1e-12L)
            break;
    }
    real load = expl(x); /* x is of the order of 30 and costs digits: once more, in F* itself */
    return load * (1 + (film(p, load) / h - 1) / (a + b * r / (1 + r)));
}

/* --- Balance: Eqs. 1, 2 and 9 --- */

static int film_falls(const Point *p) /* a film whose W is of the total load has one thickness */
{
    return !p->dry && !p->how.total;
}

/* ln of (F_f + F_s)/F_t, where summits alone would bear ``summit_load``. */
static real balance(const Point *p, Gap gap, real summit_load)
{
    real force = summit_load * fmaxl(0, 1 - p->coverage_by_all) + particle_load(p, gap);
    real load = p->in.load;
    if (film_falls(p))
        force += film_load(p, separation(p, gap));
    if (force <= 0)
        return NOTHING;
    return fabsl(force - load) < 0.5L * load ? log1pl((force - load) / load) : logl(force / load);
}

static real imbalance(const Point *p, Gap gap)
{
    return balance(p, gap, summits(p, gap, LOAD));
}

static Gap at(real h)
{
    return (Gap){0, 0, h};
}

/* Chandrupatla's method for the offset between a and b, to the last digit: next to a kink, where a
 * load of 1e-300 leaves particles 1e-300 m of touch, that takes a thousand halvings. */
static Gap root(const Point *p, Gap gap, real a, real fa, real b, real fb)
{
    real c = a, fc = fa, t = 0.5L;
    for (int step = 0; step < 4000 && fa != 0 && fb != 0; step++) {
        gap.offset = a + t * (b - a);
        if (gap.offset == a || gap.offset == b)
            break;
        real f = imbalance(p, gap);
        if ((f > 0) == (fa > 0)) {
            c = a, fc = fa;
        } else {
            c = b, fc = fb, b = a, fb = fa;
        }
        a = gap.offset, fa = f;
        real xi = (a - b) / (c - b), phi = (fa - fb) / (fc - fb);
        t = 0.5L;
        if (phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi)
            t = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb);
        real least = 1.1e-19L * fmaxl(fabsl(a), fabsl(b)) / fabsl(b - a); /* one digit */
        t = least < 0.5L ? fminl(fmaxl(t, least), 1 - least) : 0.5L;
    }
    gap.offset = fabsl(fa) <= fabsl(fb) ? a : b;
    return gap;
}

/* The root between h = a and b; where it is near a kink, once more as an offset from that. */
static Gap exact_root(const Point *p, real a, real fa, real b, real fb)
{
    Gap found = root(p, at(a), a, fa, b, fb);
    if (p->two_body)
        return found;
    for (int steps = 0; steps <= 1; steps++) {
        Gap near = {1, steps, 0}, low = near, high = near;
        real apart = found.offset - separation(p, near), doubt = 1e-17L * fabsl(found.offset);
        if (fabsl(apart) > 0.1L * p->x_max || (p->h_e > 0 && fabsl(apart) > 0.5L * p->h_e))
            continue;
        low.offset = apart - doubt - 1e-3L * fabsl(apart);
        high.offset = apart + doubt + 1e-3L * fabsl(apart);
        real f_low = imbalance(p, low), f_high = imbalance(p, high);
        if ((f_low > 0) != (f_high > 0))
            return root(p, near, low.offset, f_low, high.offset, f_high);
    }
    return found;
}

/* The separation at which Eq. 1 holds; whether there is one.  A dry one may be negative. */
static int balanced(const Point *p, Gap *found)
{
    real low = p->dry ? p->in.y_s : p->alone, step = p->in.roughness;
    if (p->coverage_by_all > 1)
        return 0;
    if (film_falls(p))
        low *= 1 - 1e-15L; /* rounding must not hide the root where solids bear nothing */
    while (p->dry && imbalance(p, at(low)) <= 0) {
        low -= step;
        step *= 2;
    }
    real f_low = imbalance(p, at(low)), high = low, f_high;
    if (f_low <= 0) { /* the film takes what the solids leave */
        *found = at(p->alone);
        return 1;
    }
    real reach = fmaxl(fabsl(low), p->in.y_s + 5 * (real)p->in.sigma_s);
    while ((f_high = imbalance(p, at(high = reach *= 1.25L))) > 0)
        low = high, f_low = f_high;
    *found = exact_root(p, low, f_low, high, f_high);
    return 1;
}

/* --- One point, and many --- */

static Point set_point(const double *numbers, const int *interpretations)
{
    Point p = {.in = *(const Numbers *)numbers, .how = *(const Interpretations *)interpretations};
    const Numbers *n = &p.in;
    p.dry = n->viscosity == 0;
    p.two_body = n->diameter == 0 || n->density == 0;
    p.hardness = fminl(n->H_s1, n->H_s2);
    real root_of_first = 0.75L * PI * n->k * p.hardness / n->E_ss;
    p.first = root_of_first * root_of_first * n->R / n->sigma_s;
    p.last = n->omega_ratio * p.first;
    p.log_ratio = logl(n->omega_ratio);
    real x_a = n->diameter;
    p.mean = n->mean_ratio * x_a;
    p.spread = n->sigma_a_ratio * x_a;
    p.x_max = p.mean + n->truncation * p.spread;
    p.h_e = n->h_e_ratio * x_a;
    p.plane = p.how.summit ? n->y_s : 0;
    real soft1 = (real)n->H_s1 / n->E_sa, soft2 = (real)n->H_s2 / n->E_ss;
    p.elastic_factor = 2.25L * PI * PI * (soft1 * soft1 + soft2 * soft2);
    p.coverage_by_all = p.two_body ? 0 : loaded_density(&p) * n->H_s1 * moment(&p, INFINITY, 0);
    if (!p.dry) {
        set_film(&p);
        p.alone = film(&p, n->load);
    }
    return p;
}

static Root set_root(const Point *p, Gap gap)
{
    real load = p->in.load, h = separation(p, gap), sa = particles(p, gap);
    real ss = summits(p, gap, AREA) * fmaxl(0, 1 - touching_coverage(p, gap));
    Root r = {.separation = h, .area = ss + sa, .film = h / p->in.R_x};
    r.particle_ratio = sa > 0 ? sa / (ss + sa) : 0; /* Eq. 10 */
    r.summit_ratio = sa > 0 ? ss / (ss + sa) : 1;
    r.solid_fraction = 1; /* Eq. 9; the smaller is computed, the larger is what it leaves of 1 */
    if (p->dry || (p->how.total && h > p->alone))
        return r;
    r.solid_fraction = solids(p, gap) / load;
    r.fluid_fraction = p->how.total ? 1 - r.solid_fraction : film_load(p, h) / load;
    if (r.solid_fraction < r.fluid_fraction)
        r.fluid_fraction = 1 - r.solid_fraction;
    else
        r.solid_fraction = 1 - r.fluid_fraction;
    return r;
}

/* numbers[count][26], interpretations[count][2]; found[i]: whether roots[i] has values. */
void solve(long count, const double *numbers, const int *interpretations, Root *roots, int *found)
{
    for (long i = 0; i < count; i++) {
        Point p = set_point(numbers + 26 * i, interpretations + 2 * i);
        Gap gap;
        if ((found[i] = balanced(&p, &gap)))
            roots[i] = set_root(&p, gap);
    }
}

/* F_s*, A_ss*, A_sa* and F_f* at given separations, whether or not they balance a load. */
void evaluate(long count, const double *numbers, const int *interpretations, const real *h, real *forces)
{
    for (long i = 0; i < count; i++) {
        Point p = set_point(numbers + 26 * i, interpretations + 2 * i);
        forces[4 * i] = solids(&p, at(h[i]));
        forces[4 * i + 1] = summits(&p, at(h[i]), AREA);
        forces[4 * i + 2] = particles(&p, at(h[i]));
        forces[4 * i + 3] = p.dry ? 0 : film_load(&p, h[i]);
    }
}
