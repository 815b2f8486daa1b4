/* The past of delayed values: pieces against functions that are known, and their number against the room. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "lag/delays/pieces.h"

/* exp(-t) sin(3 t), and t^8, a polynomial of the degree of a piece. */
static double known(size_t i, double t)
{
    return i == 0 ? exp(-t) * sin(3.0 * t) : pow(t, 8.0);
}

static double *place(lag_delay_pieces *pieces)
{
    double *memory = calloc(lag_delay_pieces_memory(2), sizeof *memory);
    CHECK(memory != NULL);
    lag_delay_pieces_place(pieces, 2, memory);
    pieces->level = LAG_DELAY_SMOOTH;
    pieces->length = 1.0;
    return memory;
}

static double try_to(lag_delay_pieces *pieces, double tolerance, double end)
{
    const double begin = lag_delay_end(pieces);
    for (size_t j = 0; j < LAG_DELAY_SAMPLES; ++j) {
        const double t = begin + 0.5 * (end - begin) * (1.0 + lag_delay_places[j]);
        pieces->sample[2 * j] = known(0, t);
        pieces->sample[2 * j + 1] = known(1, t);
    }
    return lag_delay_try(pieces, tolerance, end);
}

static void check_values(const lag_delay_pieces *pieces, double from, double to, double tolerance)
{
    for (double t = from; t <= to; t += 0.01 * (to - from)) {
        double rate = 0.0;
        CHECK_NEAR(lag_delay_value(pieces, lag_delay_piece(pieces, t), 0, t, &rate), known(0, t), tolerance);
        CHECK_NEAR(rate, exp(-t) * (3.0 * cos(3.0 * t) - sin(3.0 * t)), 1e3 * tolerance);
        CHECK_NEAR(lag_delay_value(pieces, lag_delay_piece(pieces, t), 1, t, &rate), known(1, t), tolerance);
    }
}

/* A piece that is accepted is as exact as it says. */
static void a_piece_is_within_its_limit(void)
{
    for (double tolerance = 1e-3; tolerance > 1e-12; tolerance *= 0.1) {
        lag_delay_pieces pieces;
        double *memory = place(&pieces);
        double h = 1.0;
        while (try_to(&pieces, tolerance, h) > 1.0) {
            h *= 0.5;
        }
        CHECK(h > 0.01 && lag_delay_add(&pieces) == LAG_OK);
        check_values(&pieces, 0.0, h, 2.0 * tolerance);
        free(memory);
    }
}

/* Many short pieces become long ones; what is older than the longest delay goes. */
static void short_pieces_become_long_ones(void)
{
    lag_delay_pieces pieces;
    double *memory = place(&pieces);
    for (size_t k = 1; k <= 10 * LAG_DELAY_PIECES; ++k) {
        (void)try_to(&pieces, 1e-10, 2.0 * (double)k / (10.0 * LAG_DELAY_PIECES));
        CHECK(lag_delay_add(&pieces) == LAG_OK);
    }
    CHECK(pieces.count - pieces.first < LAG_DELAY_PIECES);
    check_values(&pieces, 1.0, 2.0, 1e-7);
    free(memory);
}

/* Pieces between jumps stay, and their number has an end. */
static void jumps_stay(void)
{
    lag_delay_pieces pieces;
    double *memory = place(&pieces);
    size_t count = 0;
    lag_status status = LAG_OK;
    while (status == LAG_OK) {
        ++count;
        (void)try_to(&pieces, 1e-10, 1e-6 * (double)count);
        pieces.level = 1;
        status = lag_delay_add(&pieces);
    }
    CHECK(status == LAG_LONG_PAST && count + 1 == LAG_DELAY_PIECES);
    free(memory);
}

/* A jump is where the values differ; what is cut is forgotten, but for its jump. */
static void jumps_are_seen(void)
{
    lag_delay_pieces pieces;
    double *memory = place(&pieces);
    (void)try_to(&pieces, 1e-6, 0.1);
    CHECK(lag_delay_add(&pieces) == LAG_OK);
    pieces.level = 0;
    (void)try_to(&pieces, 1e-6, 0.2);
    CHECK(lag_delay_add(&pieces) == LAG_OK);
    CHECK(pieces.order[1] == 1.0 && !lag_delay_is_jump(&pieces, 1, 0));
    pieces.level = 0;
    (void)try_to(&pieces, 1e-6, 0.3);
    for (size_t j = 0; j < LAG_DELAY_SAMPLES; ++j) {
        pieces.sample[2 * j] = 5.0;
    }
    (void)lag_delay_try(&pieces, 1e-6, 0.3);
    CHECK(lag_delay_add(&pieces) == LAG_OK);
    CHECK(pieces.order[2] == 0.0 && lag_delay_is_jump(&pieces, 2, 0) && !lag_delay_is_jump(&pieces, 2, 1));
    lag_delay_cut(&pieces, 0.15);
    CHECK(pieces.count == 2 && pieces.level == 0 && lag_delay_end(&pieces) == 0.2);
    free(memory);
}

int main(void)
{
    a_piece_is_within_its_limit();
    short_pieces_become_long_ones();
    jumps_stay();
    jumps_are_seen();
    return EXIT_SUCCESS;
}
