#include "lag/signals.h"

/* Number of times that are less than t, with `equal` not greater. */
static size_t place_of(const lag_signal *signal, double t, int equal)
{
    size_t low = 0;
    size_t high = signal->count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (equal ? signal->time[middle] <= t : signal->time[middle] < t) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

static double line(const lag_signal *signal, size_t place, double t)
{
    const size_t end = place < 1 ? 1 : place < signal->count ? place : signal->count - 1;
    const double *time = signal->time + end;
    const double *value = signal->value + end;
    const double part = time[0] > time[-1] ? (t - time[-1]) / (time[0] - time[-1]) : 1.0;
    return value[-1] + part * (value[0] - value[-1]);
}

static double polynomial(const lag_signal *signal, size_t place, double t)
{
    const size_t last = signal->count - 2;
    const size_t piece = place < 1 ? 0 : place - 1 < last ? place - 1 : last;
    const double *coefficient = signal->value + piece * signal->terms;
    const double x = t - signal->time[piece];
    double total = 0.0;
    for (size_t i = 0; i < signal->terms; ++i) {
        total = total * x + coefficient[i];
    }
    return total;
}

double lag_signal_at(const lag_signal *signal, double t, int before)
{
    const size_t place = place_of(signal, t, !before);
    switch (signal->kind) {
    case LAG_SIGNAL_STEPS:
        return signal->value[place < 1 ? 0 : place - 1];
    case LAG_SIGNAL_LINES:
        return line(signal, place, t);
    case LAG_SIGNAL_POLYNOMIAL:
        return polynomial(signal, place, t);
    case LAG_SIGNAL_HELD:
        break;
    }
    return 0.0;
}

void lag_signals_tell(void *context, double t, int before, double *u)
{
    const lag_signals *signals = context;
    for (size_t i = 0; i < signals->count; ++i) {
        if (signals->signal[i].kind != LAG_SIGNAL_HELD) {
            u[i] = lag_signal_at(&signals->signal[i], t, before);
        }
    }
}
