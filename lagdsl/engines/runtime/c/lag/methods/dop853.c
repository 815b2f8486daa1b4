/*
 * The explicit Runge-Kutta method of Dormand and Prince of order 8 with error estimates of orders 5 and 3 and dense output of
 * order 7, with PI step control.
 *
 * Source: Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, 2nd ed., sections II.5 (method, page 181),
 * II.6 (dense output), II.10 (error estimate); coefficients as in the authors' program DOP853. Step control: Hairer and Wanner,
 * Solving Ordinary Differential Equations II, 2nd ed., section IV.2 (formula 2.43); the measure of stiffness: there, (2.38).
 */
#define LAG_LANES_AMONG_SINGLES

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/lanes.h"
#include "lag/stepper.h"

enum { STAGES_OF_STEP = 12, SLOPE_AT_END = 12, SLOPES = 16, DENSE_TERMS = 7 };

/* A sum of slopes, for the state at `node`. */
typedef struct combination {
    double node;
    unsigned count;
    unsigned char slope[13];
    double weight[13];
} combination;

/* 12: the step itself; 13 to 15: further stages of the dense output. */
static const combination STAGES[16] = {
    {0.0, 1, {0},
     {0.0}},
    {0.526001519587677318785587544488e-01, 1, {0},
     {5.26001519587677318785587544488e-2}},
    {0.789002279381515978178381316732e-01, 2, {0, 1},
     {1.97250569845378994544595329183e-2, 5.91751709536136983633785987549e-2}},
    {0.118350341907227396726757197510, 2, {0, 2},
     {2.95875854768068491816892993775e-2, 8.87627564304205475450678981324e-2}},
    {0.281649658092772603273242802490, 3, {0, 2, 3},
     {2.41365134159266685502369798665e-1, -8.84549479328286085344864962717e-1,
      9.24834003261792003115737966543e-1}},
    {0.333333333333333333333333333333, 3, {0, 3, 4},
     {3.7037037037037037037037037037e-2, 1.70828608729473871279604482173e-1,
      1.25467687566822425016691814123e-1}},
    {0.25, 4, {0, 3, 4, 5},
     {3.7109375e-2, 1.70252211019544039314978060272e-1, 6.02165389804559606850219397283e-2,
      -1.7578125e-2}},
    {0.307692307692307692307692307692, 5, {0, 3, 4, 5, 6},
     {3.70920001185047927108779319836e-2, 1.70383925712239993810214054705e-1,
      1.07262030446373284651809199168e-1, -1.53194377486244017527936158236e-2,
      8.27378916381402288758473766002e-3}},
    {0.651282051282051282051282051282, 6, {0, 3, 4, 5, 6, 7},
     {6.24110958716075717114429577812e-1, -3.36089262944694129406857109825,
      -8.68219346841726006818189891453e-1, 2.75920996994467083049415600797e1,
      2.01540675504778934086186788979e1, -4.34898841810699588477366255144e1}},
    {0.6, 7, {0, 3, 4, 5, 6, 7, 8},
     {4.77662536438264365890433908527e-1, -2.48811461997166764192642586468,
      -5.90290826836842996371446475743e-1, 2.12300514481811942347288949897e1,
      1.52792336328824235832596922938e1, -3.32882109689848629194453265587e1,
      -2.03312017085086261358222928593e-2}},
    {0.857142857142857142857142857142, 8, {0, 3, 4, 5, 6, 7, 8, 9},
     {-9.3714243008598732571704021658e-1, 5.18637242884406370830023853209,
      1.09143734899672957818500254654, -8.14978701074692612513997267357,
      -1.85200656599969598641566180701e1, 2.27394870993505042818970056734e1,
      2.49360555267965238987089396762, -3.0467644718982195003823669022}},
    {1.0, 9, {0, 3, 4, 5, 6, 7, 8, 9, 10},
     {2.27331014751653820792359768449, -1.05344954667372501984066689879e1,
      -2.00087205822486249909675718444, -1.79589318631187989172765950534e1,
      2.79488845294199600508499808837e1, -2.85899827713502369474065508674,
      -8.87285693353062954433549289258, 1.23605671757943030647266201528e1,
      6.43392746015763530355970484046e-1}},
    {1.0, 8, {0, 5, 6, 7, 8, 9, 10, 11},
     {5.42937341165687622380535766363e-2, 4.45031289275240888144113950566,
      1.89151789931450038304281599044, -5.8012039600105847814672114227,
      3.1116436695781989440891606237e-1, -1.52160949662516078556178806805e-1,
      2.01365400804030348374776537501e-1, 4.47106157277725905176885569043e-2}},
    {0.1, 8, {0, 6, 7, 8, 9, 10, 11, 12},
     {5.61675022830479523392909219681e-2, 2.53500210216624811088794765333e-1,
      -2.46239037470802489917441475441e-1, -1.24191423263816360469010140626e-1,
      1.5329179827876569731206322685e-1, 8.20105229563468988491666602057e-3,
      7.56789766054569976138603589584e-3, -8.298e-3}},
    {0.2, 8, {0, 5, 6, 7, 10, 11, 12, 13},
     {3.18346481635021405060768473261e-2, 2.83009096723667755288322961402e-2,
      5.35419883074385676223797384372e-2, -5.49237485713909884646569340306e-2,
      -1.08347328697249322858509316994e-4, 3.82571090835658412954920192323e-4,
      -3.40465008687404560802977114492e-4, 1.41312443674632500278074618366e-1}},
    {0.777777777777777777777777777778, 8, {0, 5, 6, 7, 8, 12, 13, 14},
     {-4.28896301583791923408573538692e-1, -4.69762141536116384314449447206,
      7.68342119606259904184240953878, 4.06898981839711007970213554331,
      3.56727187455281109270669543021e-1, -1.39902416515901462129418009734e-3,
      2.9475147891527723389556272149, -9.15095847217987001081870187138}}
};

static const combination ERROR5 =
{1.0, 8, {0, 5, 6, 7, 8, 9, 10, 11},
    {0.1312004499419488073250102996e-1, -0.1225156446376204440720569753e+1,
     -0.4957589496572501915214079952, 0.1664377182454986536961530415e+1,
     -0.3503288487499736816886487290, 0.3341791187130174790297318841, 0.8192320648511571246570742613e-1,
     -0.2235530786388629525884427845e-1}};

/* Stages whose states are of the fifth order, as places of the step. */
static const unsigned char PASSES[STAGES_OF_STEP] = {[6] = 1, [9] = 2, [10] = 3};

static const combination DENSE[4] = {
    {1.0, 12, {0, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15},
     {-0.84289382761090128651353491142e+1, 0.56671495351937776962531783590,
      -0.30689499459498916912797304727e+1, 0.23846676565120698287728149680e+1,
      0.21170345824450282767155149946e+1, -0.87139158377797299206789907490,
      0.22404374302607882758541771650e+1, 0.63157877876946881815570249290,
      -0.88990336451333310820698117400e-1, 0.18148505520854727256656404962e+2,
      -0.91946323924783554000451984436e+1, -0.44360363875948939664310572000e+1}},
    {1.0, 12, {0, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15},
     {0.10427508642579134603413151009e+2, 0.24228349177525818288430175319e+3,
      0.16520045171727028198505394887e+3, -0.37454675472269020279518312152e+3,
      -0.22113666853125306036270938578e+2, 0.77334326684722638389603898808e+1,
      -0.30674084731089398182061213626e+2, -0.93321305264302278729567221706e+1,
      0.15697238121770843886131091075e+2, -0.31139403219565177677282850411e+2,
      -0.93529243588444783865713862664e+1, 0.35816841486394083752465898540e+2}},
    {1.0, 12, {0, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15},
     {0.19985053242002433820987653617e+2, -0.38703730874935176555105901742e+3,
      -0.18917813819516756882830838328e+3, 0.52780815920542364900561016686e+3,
      -0.11573902539959630126141871134e+2, 0.68812326946963000169666922661e+1,
      -0.10006050966910838403183860980e+1, 0.77771377980534432092869265740,
      -0.27782057523535084065932004339e+1, -0.60196695231264120758267380846e+2,
      0.84320405506677161018159903784e+2, 0.11992291136182789328035130030e+2}},
    {1.0, 12, {0, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15},
     {-0.25693933462703749003312586129e+2, -0.15418974869023643374053993627e+3,
      -0.23152937917604549567536039109e+3, 0.35763911791061412378285349910e+3,
      0.93405324183624310003907691704e+2, -0.37458323136451633156875139351e+2,
      0.10409964950896230045147246184e+3, 0.29840293426660503123344363579e+2,
      -0.43533456590011143754432175058e+2, 0.96324553959188282948394950600e+2,
      -0.39177261675615439165231486172e+2, -0.14972683625798562581422125276e+3}}
};

/* Difference of the new state from the embedded formula of order 3. */
static const combination THIRD = {1.0, 3, {0, 8, 11},
    {-0.244094488188976377952755905512, -0.733846688281611857341361741547, -0.220588235294117647058823529412e-1}};

static const double SAFETY = 0.8;
static const double BETA = 0.04; /* weight of the error before, in the step control */
static const double SHRINK = 0.333;
static const double GROW = 3.0; /* more would harm the dense output of the step that follows a transient */
static const double AFTER_TROUBLE = 0.25;

typedef struct places {
    double *slope; /* (16, size) */
    double *stage; /* (size) */
    double *x_new; /* (size) */
    double *dense; /* (7, size) */
} places;

static places place(const lag_stepper *s)
{
    const size_t size = s->ode->size;
    return (places){s->work, s->work + SLOPES * size, s->work + (SLOPES + 1) * size, s->work + (SLOPES + 2) * size};
}

static size_t memory(size_t size)
{
    return (SLOPES + 2 + DENSE_TERMS) * size;
}

#if LAG_LANES
/* Several entries at i of the weighted slopes, added to `sum`. */
static lag_lanes add_lanes(size_t size, const combination *c, const double *slope, size_t i, lag_lanes sum)
{
    for (unsigned j = 0; j < c->count; ++j) {
        sum += c->weight[j] * *(const lag_lanes_memory *)(const void *)(slope + c->slope[j] * size + i);
    }
    return sum;
}

static lag_lanes lanes_at(const double *x, size_t i)
{
    return *(const lag_lanes_memory *)(const void *)(x + i);
}
#endif

/* The entry at i of the weighted slopes, added to `sum`. */
static double add(size_t size, const combination *c, const double *slope, size_t i, double sum)
{
    for (unsigned j = 0; j < c->count; ++j) {
        sum += c->weight[j] * slope[c->slope[j] * size + i];
    }
    return sum;
}

/* out = base + h * sum; base may be null. Several entries at once where there are vectors, with the same bits. */
static void combine(
    size_t size, const combination *c, double h, const double *slope, const double *base, double *out)
{
    size_t i = 0;
#if LAG_LANES
    for (; i + LAG_LANES <= size; i += LAG_LANES) {
        const lag_lanes from = base != NULL ? lanes_at(base, i) : lag_lanes_of(0.0);
        *(lag_lanes_memory *)(void *)(out + i) = from + h * add_lanes(size, c, slope, i, lag_lanes_of(0.0));
    }
#endif
    for (; i < size; ++i) {
        out[i] = (base != NULL ? base[i] : 0.0) + h * add(size, c, slope, i, 0.0);
    }
}

/* All stages and the new state; the slope at its end is left to an accepted step. */
static lag_status try_step(lag_stepper *s, const places *at, double h)
{
    const size_t size = s->ode->size;
    memcpy(at->slope, s->f, size * sizeof(double));
    for (size_t i = 1; i < STAGES_OF_STEP; ++i) {
        combine(size, &STAGES[i], h, at->slope, s->x, at->stage);
        const lag_status status = lag_stepper_rates(s, s->t + STAGES[i].node * h, at->stage, at->slope + i * size);
        if (status != LAG_OK) {
            return status;
        }
        if (PASSES[i] > 0) {
            lag_stepper_pass(s, PASSES[i], s->t + STAGES[i].node * h);
        }
    }
    combine(size, &STAGES[SLOPE_AT_END], h, at->slope, s->x, at->x_new);
    return LAG_OK;
}

/* Both estimates together, section II.10, formula (10.17). */
static double error_of(const lag_stepper *s, const places *at, double h)
{
    const size_t size = s->ode->size;
    const combination *step = &STAGES[SLOPE_AT_END];
    double fifth = 0.0;
    double third = 0.0;
    size_t i = 0;
#if LAG_LANES
    for (; i + LAG_LANES <= size; i += LAG_LANES) {
        const lag_lanes zero = lag_lanes_of(0.0);
        const lag_lanes e5 = add_lanes(size, &ERROR5, at->slope, i, zero) / lanes_at(s->tolerance, i);
        const lag_lanes e3 = add_lanes(size, step, at->slope, i, add_lanes(size, &THIRD, at->slope, i, zero)) / lanes_at(s->tolerance, i);
        for (size_t lane = 0; lane < LAG_LANES; ++lane) {
            fifth += e5[lane] * e5[lane];
            third += e3[lane] * e3[lane];
        }
    }
#endif
    for (; i < size; ++i) {
        const double e5 = add(size, &ERROR5, at->slope, i, 0.0) / s->tolerance[i];
        const double e3 = add(size, step, at->slope, i, add(size, &THIRD, at->slope, i, 0.0)) / s->tolerance[i];
        fifth += e5 * e5;
        third += e3 * e3;
    }
    const double both = fifth + 0.01 * third;
    if (!isfinite(both)) {
        return (double)INFINITY;
    }
    return both > 0.0 ? h * fifth / sqrt(both * (double)size) : 0.0;
}

/* h |lambda|, from the last stage and the new state, both at the end of the step. */
static double urge_of(const lag_stepper *s, const places *at, double h)
{
    const size_t size = s->ode->size;
    const double *end = at->slope + SLOPE_AT_END * size;
    const double *last = at->slope + (STAGES_OF_STEP - 1) * size;
    double change = 0.0;
    double distance = 0.0;
    for (size_t i = 0; i < size; ++i) {
        const double by = (end[i] - last[i]) / s->tolerance[i];
        const double of = (at->x_new[i] - at->stage[i]) / s->tolerance[i];
        change += by * by;
        distance += of * of;
    }
    return distance > 0.0 ? h * sqrt(change / distance) : 0.0;
}

/* Factor for the next step after this error; `before`: the error of the last accepted step. */
static double factor_of(double error, double before)
{
    const double integral = pow(error, 1.0 / 8.0 - 0.2 * BETA);
    const double factor = SAFETY / integral * pow(fmax(before, 1e-4), BETA);
    return fmin(GROW, fmax(SHRINK, error > 0.0 ? factor : GROW));
}

static lag_status step(lag_stepper *s, double limit)
{
    const places at = place(s);
    double *end_slope = at.slope + SLOPE_AT_END * s->ode->size;
    for (int rejected = 0;; rejected = 1) {
        const double proposed = fmin(s->h, s->h_most);
        const double h = lag_stepper_length(s, limit);
        const double t_new = lag_stepper_end(s, h, limit);
        lag_status status = try_step(s, &at, h);
        const double error = status == LAG_OK ? error_of(s, &at, h) : (double)INFINITY;
        if (error <= 1.0) {
            status = lag_stepper_rates(s, t_new, at.x_new, end_slope);
        }
        if (error <= 1.0 && status == LAG_OK) {
            const double factor = factor_of(error, s->last.error > 0.0 ? s->last.error : 1e-4);
            const double next = h * (rejected ? fmin(factor, 1.0) : factor);
            s->last.urge = urge_of(s, &at, h);
            s->h = h < proposed && !rejected ? fmax(next, proposed) : next;
            s->last.error = fmax(error, 1e-4);
            s->last.h = h;
            lag_stepper_pass(s, LAG_PASSED_END, t_new);
            lag_stepper_accept(s, t_new, at.x_new, end_slope);
            return LAG_OK;
        }
        ++s->counts.rejections;
        if (h <= s->h_least) {
            return LAG_STEP_TOO_SMALL;
        }
        s->h = fmax(h * (isfinite(error) && error > 1.0 ? fmax(SHRINK, SAFETY * pow(error, -1.0 / 8.0)) : AFTER_TROUBLE), s->h_least);
    }
}

static void begin(lag_stepper *s)
{
    (void)s;
}

/* Terms of the polynomial that Hairer, Norsett and Wanner give at the end of section II.6. */
static lag_status prepare_dense(lag_stepper *s)
{
    const places at = place(s);
    const size_t size = s->ode->size;
    const double h = s->t - s->t_before;
    for (size_t i = SLOPE_AT_END + 1; i < SLOPES; ++i) {
        combine(size, &STAGES[i], h, at.slope, s->x_before, at.stage);
        const lag_status status =
            lag_stepper_rates(s, s->t_before + STAGES[i].node * h, at.stage, at.slope + i * size);
        if (status != LAG_OK) {
            return status;
        }
    }
    for (size_t i = 0; i < size; ++i) {
        const double change = at.x_new[i] - s->x_before[i];
        const double first = at.slope[i];
        const double last = at.slope[SLOPE_AT_END * size + i];
        at.dense[i] = change;
        at.dense[size + i] = h * first - change;
        at.dense[2 * size + i] = 2.0 * change - h * (last + first);
    }
    for (size_t k = 0; k < 4; ++k) {
        combine(size, &DENSE[k], h, at.slope, NULL, at.dense + (3 + k) * size);
    }
    return LAG_OK;
}

static void dense(const lag_stepper *s, double t, double *x)
{
    const places at = place(s);
    const size_t size = s->ode->size;
    const double h = s->t - s->t_before;
    const double part = h > 0.0 ? (t - s->t_before) / h : 1.0;
    for (size_t i = 0; i < size; ++i) {
        double sum = 0.0;
        for (size_t k = DENSE_TERMS; k-- > 0;) {
            sum = (sum + at.dense[k * size + i]) * (k % 2 == 0 ? part : 1.0 - part);
        }
        x[i] = s->x_before[i] + sum;
    }
}

const lag_method lag_dop853 = {
    .name = "dop853",
    .order = 8,
    .highest_order = 8,
    .dense_order = 7,
    .implicit = 0,
    .factor = 1e-2,
    .error_order = 7,
    .memory = memory,
    .begin = begin,
    .step = step,
    .prepare_dense = prepare_dense,
    .dense = dense,
};
