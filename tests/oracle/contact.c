/* The model of Chen & Horng (2024) in long double: every separation that balances the forces.
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
 *     diameter".  `phi_a`: "uncentred" as printed, "centred" about `mean_ratio` x_a, and
 *     "gap_convolved", where a particle meets the gap as it is at its place.
 * 4.  Truncation.  "x_max is maximum particle size": X_max = mean + `truncation` times the spread of
 *     sizes.  The density is that of Eq. 6, not divided by what truncation leaves of it.
 * 5.  Smallest size.  "x_min is minimum particle size", of which no value is given: zero.  No integral
 *     reaches below it, also where d < h_e.  "gap_convolved" has no X_min: its variable is a size
 *     less the deviation of the gap, which may be negative.
 * 6.  Elastic particles.  `elastic_limits`: "printed" as in Eqs. 4 and 5, elastic in (d - h_e, d) and
 *     plastic in (d, X_max), though a particle of diameter below d touches only one surface;
 *     "physical": a particle is elastic while it is squeezed by less than h_e, so those in
 *     (d, d + h_e) are, and plastic ones begin at d + h_e.  No particle is in both integrals.
 * 7.  h_e, "maximum separation of two surfaces with particles that lead to plastic contact", has no
 *     value: it is `h_e_ratio` x_a, the same for all sizes of one mixture.
 * 8.  Coverage.  Eq. 4 takes from F_ss the share that particles of all sizes cover (X_min to X_max),
 *     Eq. 5 takes from A_ss the share of those that touch (d to X_max).  `coverage_limits`: "printed"
 *     as in Eq. 4, "contacting" takes the limits of Eq. 5 in both.  Where the share exceeds 1 the
 *     equation has no meaning, and no value is given.
 * 9.  Participation.  "eta_a is particle density" per area of interface; `participation` is the
 *     fraction of them that bears load.  The others do not touch, so they cover nothing either:
 *     it multiplies eta_a wherever that stands.  The print means 1.
 * 10. Load of the film.  Eq. 8 prints W = F_t/(E_ss R_x^2), but the paper's own film thicknesses join
 *     the dry curve only if the fluid's share is meant.  `film_load`: "fluid" puts F_f into W,
 *     "total" F_t.  A film under the total load holds its thickness whatever it bears: it takes
 *     what the solids leave, and nothing where they hold the surfaces farther apart.
 * 11. Area ratios.  "A_ss,t* = A_ss/A_t" (Eq. 10) adds up to 1 with A_sa,t* only if A_ss means what
 *     particles leave of it, the A_ss-sa of Eq. 5.
 * 12. Several separations.  Soft particles (elastic factor above 1), or contacting coverage, can make
 *     F_s rise with d: then Eq. 1 may hold at several separations.  All are found, and the largest
 *     is taken, which two closing surfaces meet first.
 */
#include <math.h>

typedef long double real;

enum { NODES = 24, MOST_ROOTS = 8, EDGES = 8 };
enum { UNCENTRED, CENTRED, GAP_CONVOLVED };
enum { ELASTIC, ELASTOPLASTIC, PLASTIC };
enum { LOAD, AREA, LOAD_SLOPE, SLOPE_EXCESS };

static const real PI = 3.141592653589793238462643383279502884L;
static const real REACH = 10.5L; /* exp(-REACH^2/2) = 1e-24 of an integrand's largest value */
static const real NOTHING = -1e9L; /* ln of no force at all */

/* One point: the order in which extended.py hands the numbers over. */
typedef struct {
    double load, viscosity, diameter, roughness, density;
    double eta_s, R, sigma_s, y_s;
    double E_ss, E_sa, H_s1, H_s2, k, omega_ratio;
    double R_x, G, V, kappa, U_per_viscosity, A_n;
    double mean_ratio, sigma_a_ratio, gap_ratio, truncation, participation, h_e_ratio;
} Numbers;

typedef struct {
    int phi_a;      /* UNCENTRED, CENTRED, GAP_CONVOLVED */
    int summit;     /* particle_plane: 1 = summit */
    int physical;   /* elastic_limits */
    int contacting; /* coverage_limits */
    int total;      /* film_load */
} Interpretations;

typedef struct {
    real separation, solid_fraction, fluid_fraction, area, particle_ratio, summit_ratio, film;
} Root;

typedef struct {
    Numbers in;
    Interpretations how;
    int two_body, dry;
    real hardness, first, last, log_ratio; /* of summits; omega_1, omega_2 over sigma_s */
    real mean, spread, x_min, x_max, h_e; /* of sizes */
    real elastic_factor, plane, mean_square, coverage_by_all;
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
    int law, what; /* LOAD, AREA, LOAD_SLOPE, SLOPE_EXCESS */
} Summit;

/* The slope of a summit's load, f'(w), as a difference of two functions that rise with w: f' + g and g.  Integrals of
 * either over a Gaussian fall as the surfaces part, and so enclose the slope of F_ss between two separations.
 * g is the term -6 u^2 w/(last - first) of the area's slope, and the steps down of f' at both kinks. */
static real summit_slope(const Summit *s, real w)
{
    const Point *p = s->p;
    real k = p->in.k, log_slope = (1 - k) / p->log_ratio, width = p->last - p->first;
    if (s->law == ELASTIC)
        return s->what == SLOPE_EXCESS ? 0 : 2 * sqrtl(w * p->in.sigma_s / p->in.R);
    real unit = PI * p->hardness / p->in.E_ss, step = width > 0 ? fmaxl(0, 0.5L * k - log_slope) : 0;
    if (s->law == PLASTIC) {
        real excess = width > 0 ? step + 6 * p->last / width + 2 * log_slope : 0;
        return unit * (s->what == SLOPE_EXCESS ? excess : excess + 2);
    }
    real u = (w - p->first) / width, growth = 1 + u * u * (3 - 2 * u);
    real pressure = 1 - log_slope * logl(p->last / w), bend = 6 * u * w * pressure / width;
    return unit * (step + (s->what == SLOPE_EXCESS ? u * bend : growth * (pressure + log_slope) + bend));
}

/* Area over R sigma_s, or load over E_ss R sigma_s, of a summit at interference w sigma_s. */
static real one_summit(real w, const void *what)
{
    const Summit *s = what;
    const Point *p = s->p;
    if (s->what >= LOAD_SLOPE)
        return summit_slope(s, w);
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

/* F_ss* or A_ss*, were there no particles; of the slopes, the integrals times sigma_s. */
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
    if (s->p->how.phi_a == GAP_CONVOLVED)
        return s->p->mean_square;
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
    from = fminl(from, p->x_max - fmaxl(p->x_min, p->mean - 200 * p->spread));
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

/* A_sa*, Eq. 5, where the elastic sizes begin at ``first`` and the plastic ones at ``second``, both
 * as distances below X_max, and elastic ones end at ``end``. */
static real particle_area(const Point *p, real first, real end, real second)
{
    return loaded_density(p) * p->in.H_s2
           * (p->elastic_factor * moment(p, first, end) + moment(p, second, 0));
}

/* Limits of Eqs. 4 and 5: printed d - h_e and d, physical d and d + h_e. */
static real elastic_from(const Point *p, Gap gap)
{
    return below_largest(p, gap, p->how.physical - 1);
}

static real plastic_from(const Point *p, Gap gap)
{
    return below_largest(p, gap, p->how.physical);
}

/* A_sa*; F_sa* is H_s1/E_ss of it (Eq. 4). */
static real particles(const Point *p, Gap gap)
{
    real plastic = plastic_from(p, gap);
    return p->two_body ? 0 : particle_area(p, elastic_from(p, gap), plastic, plastic);
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

/* What Eq. 4 takes from 1. */
static real load_coverage(const Point *p, Gap gap)
{
    return p->how.contacting ? touching_coverage(p, gap) : p->coverage_by_all;
}

/* F_s*, Eq. 4. */
static real solids(const Point *p, Gap gap)
{
    return summits(p, gap, LOAD) * fmaxl(0, 1 - load_coverage(p, gap)) + particle_load(p, gap);
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
    real force = summit_load * fmaxl(0, 1 - load_coverage(p, gap)) + particle_load(p, gap);
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
    for (int steps = -1; steps <= 1; steps++) {
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

/* The smallest size that counts. */
static real smallest(const Point *p)
{
    return fmaxl(p->x_min, p->mean - REACH * p->spread);
}

/* Separations in order: the kinks of F_s, and where the smallest sizes that count begin. */
static int edges_of(const Point *p, real *h)
{
    if (p->two_body)
        return 0;
    real first = smallest(p), last = p->x_max, h_e = p->h_e;
    real d[EDGES] = {first - h_e, first, first + h_e, 0, h_e, last - h_e, last, last + h_e};
    for (int i = 0; i < EDGES; i++) {
        int j = i;
        for (; j > 0 && h[j - 1] > p->plane + d[i]; j--)
            h[j] = h[j - 1];
        h[j] = p->plane + d[i];
    }
    return EDGES;
}

/* The h where contacting particles cover all of surface 2, between a (too much) and b. */
static real covered(const Point *p, real a, real b)
{
    for (;;) {
        real middle = 0.5L * (a + b);
        if (middle == a || middle == b)
            return b;
        if (load_coverage(p, at(middle)) > 1)
            a = middle;
        else
            b = middle;
    }
}

/* The least h where Eq. 1 can hold; -1 where particles cover too much wherever it could. */
static int lowest(const Point *p, real first, real *low)
{
    if (p->dry) {
        real step = p->in.roughness;
        for (*low = first; load_coverage(p, at(*low)) <= 1 && imbalance(p, at(*low)) <= 0; step *= 2)
            *low -= step;
    } else {
        *low = p->alone;
    }
    if (load_coverage(p, at(*low)) <= 1)
        return 0;
    if (!p->how.contacting)
        return -1;
    *low = covered(p, *low, p->plane + p->x_max);
    return 0;
}

/* One end of a part of the separations. */
typedef struct {
    real h, summit_load, f;
} End;

static End end_at(const Point *p, real h)
{
    real load = summits(p, at(h), LOAD);
    return (End){h, load, balance(p, at(h), load)};
}

/* What a value between two separations is at least and at most. */
typedef struct {
    real least, most;
} Bounds;

/* Bounds of F_s + F_f: each term is at one end what it is at most and at the other what it is at least. */
static Bounds forces_between(const Point *p, End a, End b)
{
    Gap low = at(a.h), high = at(b.h);
    Bounds force = {b.summit_load * fmaxl(0, 1 - load_coverage(p, low)),
                    a.summit_load * fmaxl(0, 1 - load_coverage(p, high))};
    if (!p->two_body) {
        real pressure = p->in.H_s1 / (real)p->in.E_ss;
        force.least += pressure * particle_area(p, elastic_from(p, high), plastic_from(p, low), plastic_from(p, high));
        force.most += pressure * particle_area(p, elastic_from(p, low), plastic_from(p, high), plastic_from(p, low));
    }
    if (film_falls(p)) {
        force.least += film_load(p, b.h);
        force.most += film_load(p, a.h);
    }
    return force;
}

/* x^2 phi_a(x), the density in I(a, b). */
static real squared_density(const Point *p, real x)
{
    Sizes sizes = {p, x};
    return squared_size(0, &sizes) * gaussian((x - p->mean) / p->spread) / p->spread;
}

/* Bounds of x^2 phi_a(x), which has one maximum, between two sizes. */
static Bounds density_between(const Point *p, real a, real b)
{
    real first = smallest(p), last = p->x_max;
    if (a > last || b < first)
        return (Bounds){0, 0};
    int gap = p->how.phi_a == GAP_CONVOLVED;
    real peak = gap ? p->mean : 0.5L * (p->mean + sqrtl(p->mean * p->mean + 8 * p->spread * p->spread));
    Bounds q = {0, squared_density(p, fminl(fmaxl(peak, fmaxl(a, first)), fminl(b, last)))};
    if (a >= first && b <= last)
        q.least = fminl(squared_density(p, a), squared_density(p, b));
    return q;
}

static Bounds times(Bounds factor, Bounds positive)
{
    return (Bounds){factor.least * (factor.least > 0 ? positive.least : positive.most),
                    factor.most * (factor.most > 0 ? positive.most : positive.least)};
}

/* dF_f/dh of a film of thickness h, which bears less the slower, the thicker it is. */
static real film_slope(const Point *p, real h)
{
    real load = film_load(p, h), r = p->film_rough * powl(load, -p->rough_power);
    return -load / h / (p->power + p->rough_power * r / (1 + r));
}

/* Whether the forces surely fall, or surely rise, all the way from a to b: then there is one root at most.
 * By Eqs. 4 and 5, d(F_s)/dd = F_ss' (1 - coverage) + unit (here q(d) + there q(d -+ h_e)), q(x) = x^2 phi_a(x). */
static int is_monotone(const Point *p, End a, End b)
{
    real pressure = p->in.H_s2 / (real)p->in.E_ss, factor = p->elastic_factor;
    real here = pressure * (p->how.physical ? -factor : factor - 1);
    real there = pressure * (p->how.physical ? factor - 1 : -factor);
    Bounds at_d = {here, here}, at_other = {there, there};
    if (p->how.contacting) /* as they lose touch, particles bare summits */
        at_d.least += b.summit_load, at_d.most += a.summit_load;
    if (p->two_body || (at_d.most <= 0 && there <= 0))
        return 1;
    real low = a.h - p->plane, high = b.h - p->plane, shift = p->how.physical ? p->h_e : -p->h_e;
    Bounds q = times(at_d, density_between(p, low, high));
    Bounds q_other = times(at_other, density_between(p, low + shift, high + shift));
    real unit = loaded_density(p) * p->in.H_s1, per_length = 1 / (real)p->in.sigma_s;
    Bounds slope = {unit * (q.least + q_other.least), unit * (q.most + q_other.most)};
    if (slope.most <= 0)
        return 1;
    real steep = summits(p, at(a.h), LOAD_SLOPE) - summits(p, at(b.h), SLOPE_EXCESS);
    real gentle = summits(p, at(b.h), LOAD_SLOPE) - summits(p, at(a.h), SLOPE_EXCESS);
    slope.least -= per_length * steep * fmaxl(0, 1 - load_coverage(p, at(b.h)));
    slope.most -= per_length * fmaxl(0, gentle) * fmaxl(0, 1 - load_coverage(p, at(a.h)));
    if (film_falls(p))
        slope.least += film_slope(p, a.h), slope.most += film_slope(p, b.h);
    real rounding = 1e-12L * fmaxl(fabsl(slope.least), fabsl(slope.most));
    return slope.most < -rounding || slope.least > rounding;
}

typedef struct {
    const Point *p;
    Gap *found;
    int count;
} Search;

/* Adds the roots between a and b, the largest first: halves that part until the forces are surely monotone in it,
 * or surely never F_t, or so nearly constant that rounding decides. */
static void search(Search *s, End a, End b)
{
    int crosses = (a.f > 0) != (b.f > 0);
    real load = s->p->in.load, middle = 0.5L * (a.h + b.h);
    if (s->count == MOST_ROOTS)
        return;
    Bounds force = forces_between(s->p, a, b);
    if (!crosses && (force.most < load * (1 - 1e-12L) || force.least > load * (1 + 1e-12L)))
        return;
    if (force.most - force.least < 1e-13L * load || middle == a.h || middle == b.h || is_monotone(s->p, a, b)) {
        if (crosses)
            s->found[s->count++] = exact_root(s->p, a.h, a.f, b.h, b.f);
        return;
    }
    End between = end_at(s->p, middle);
    search(s, between, b);
    search(s, a, between);
}

/* All roots from ``low`` on, the largest first: where rounding makes many of one, it is not left out;
 * ``edges`` are those of ``edges_of``. */
static int all_roots(const Point *p, real low, const real *edges, int count, Gap *found)
{
    int film_alone = !p->dry && low == p->alone, n = 1;
    Search s = {p, found, 0};
    if (film_alone && !p->how.total)
        low *= 1 - 1e-15L; /* rounding must not hide a root where solids bear nothing */
    End ends[EDGES + 2] = {end_at(p, low)};
    for (int i = 0; i < count; i++)
        if (edges[i] > ends[n - 1].h)
            ends[n++] = end_at(p, edges[i]);
    real h = fmaxl(fabsl(ends[n - 1].h), p->in.y_s + 5 * (real)p->in.sigma_s);
    do
        ends[n] = end_at(p, h *= 1.25L);
    while (ends[n].f > 0);
    for (; n > 0; n--)
        search(&s, ends[n - 1], ends[n]);
    if (film_alone && p->how.total && ends[0].f <= 0 && s.count < MOST_ROOTS)
        found[s.count++] = at(low); /* the film takes what the solids leave */
    return s.count;
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
    real x_a = n->diameter, own = n->sigma_a_ratio * x_a, gaps = (real)n->gap_ratio * n->roughness;
    p.mean = p.how.phi_a == UNCENTRED ? 0 : n->mean_ratio * x_a;
    p.spread = p.how.phi_a == GAP_CONVOLVED ? hypotl(own, gaps) : own;
    p.x_min = p.how.phi_a == GAP_CONVOLVED ? -INFINITY : 0;
    p.x_max = p.mean + n->truncation * p.spread;
    p.mean_square = x_a * x_a + own * own;
    p.h_e = n->h_e_ratio * x_a;
    p.plane = p.how.summit ? n->y_s : 0;
    real soft1 = (real)n->H_s1 / n->E_sa, soft2 = (real)n->H_s2 / n->E_ss;
    p.elastic_factor = p.h_e > 0 ? 2.25L * PI * PI * (soft1 * soft1 + soft2 * soft2) : 1; /* of no sizes */
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

/* numbers[count][27], interpretations[count][5]; roots[count][MOST_ROOTS], the largest separation first;
 * found[count]: how many, -1 where particles would cover more than all of the surface. */
void solve(long count, const double *numbers, const int *interpretations, Root *roots, int *found)
{
    for (long i = 0; i < count; i++) {
        Point p = set_point(numbers + 27 * i, interpretations + 5 * i);
        real edges[EDGES], low;
        Gap gaps[MOST_ROOTS];
        int count_of_edges = edges_of(&p, edges);
        real first = count_of_edges ? fminl(p.in.y_s, edges[0]) : p.in.y_s;
        found[i] = -1;
        if (lowest(&p, first, &low) < 0)
            continue;
        int n = all_roots(&p, low, edges, count_of_edges, gaps);
        found[i] = n ? n : -1;
        for (int j = 0; j < n; j++)
            roots[MOST_ROOTS * i + j] = set_root(&p, gaps[j]);
    }
}

/* F_s*, A_ss*, A_sa* and F_f* at given separations, whether or not they balance a load. */
void evaluate(long count, const double *numbers, const int *interpretations, const real *h, real *forces)
{
    for (long i = 0; i < count; i++) {
        Point p = set_point(numbers + 27 * i, interpretations + 5 * i);
        forces[4 * i] = solids(&p, at(h[i]));
        forces[4 * i + 1] = summits(&p, at(h[i]), AREA);
        forces[4 * i + 2] = particles(&p, at(h[i]));
        forces[4 * i + 3] = p.dry ? 0 : film_load(&p, h[i]);
    }
}
