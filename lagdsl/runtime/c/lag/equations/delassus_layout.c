/* The layout of lag/equations/delassus.h, and what is known of its pattern. */
#include "lag/equations/delassus.h"
#include "lag/linalg/arena.h"

size_t lag_delassus_memory(size_t n, size_t m, size_t kept)
{
    return kept > 0 ? 2 * kept * kept + kept * m + 12 * kept + 3 * n : 0;
}

/* Components have numbers below n; others belong to the first. */
static size_t chain_of(const lag_delassus *s, size_t component)
{
    return component < s->n ? component : 0;
}

/* First and last entries of rows, and their components. */
static void find_entries(lag_delassus *s, const lag_pattern *entries, const size_t *components)
{
    size_t k = 0;
    for (size_t i = 0; i < s->kept; ++i) { /* entries are listed row by row, and kept rows ascend */
        while (k < entries->count && entries->row[k] < s->row[i]) {
            ++k;
        }
        const size_t first = k;
        while (k < entries->count && entries->row[k] == s->row[i]) {
            ++k;
        }
        s->pattern.first[i] = (double)first;
        s->pattern.end[i] = (double)k;
        s->components.component[i] = components != NULL && k > first ? (double)chain_of(s, components[entries->column[first]]) : 0.0;
    }
}

/* Chains of what belongs to one component, each in its order. */
static void link_components(lag_delassus *s, const size_t *components)
{
    s->components.several = 0;
    for (size_t j = 1; j < s->n && components != NULL && s->pattern.entries != NULL && !s->components.several; ++j) {
        s->components.several = components[j] != components[0];
    }
    if (!s->components.several) {
        return;
    }
    lag_fill(s->n, (double)s->n, s->components.coordinate);
    lag_fill(s->n, (double)s->kept, s->components.leader);
    for (size_t j = s->n; j-- > 0;) {
        double *first = s->components.coordinate + chain_of(s, components[j]);
        s->components.beside[j] = *first;
        *first = (double)j;
    }
    for (size_t i = s->kept; i-- > 0;) {
        double *first = s->components.leader + (size_t)s->components.component[i];
        s->components.follower[i] = *first;
        *first = (double)i;
    }
}

void lag_delassus_place(lag_delassus *s, size_t n, size_t m, size_t kept, const size_t *row, const lag_pattern *entries,
    const size_t *components, double *memory)
{
    s->n = n;
    s->m = m;
    s->kept = kept;
    s->rank = 0;
    s->dependent = 0;
    s->row = row;
    s->response = NULL;
    s->lam_response = NULL;
    s->jacobian = NULL;
    s->pattern.entries = entries;
    s->factor = lag_take(&memory, kept * kept);
    s->left = lag_take(&memory, kept);
    s->weight = lag_take(&memory, kept);
    s->chosen = lag_take(&memory, kept);
    s->excess = lag_take(&memory, kept * m);
    s->gram = lag_take(&memory, kept * kept);
    s->work.part = lag_take(&memory, kept);
    s->work.x = lag_take(&memory, kept);
    s->work.rest = lag_take(&memory, kept);
    s->pattern.first = lag_take(&memory, kept);
    s->pattern.end = lag_take(&memory, kept);
    s->components.component = lag_take(&memory, kept);
    s->lead = lag_take(&memory, kept);
    s->reach = lag_take(&memory, kept);
    s->components.follower = lag_take(&memory, kept);
    s->components.coordinate = lag_take(&memory, n);
    s->components.beside = lag_take(&memory, n);
    s->components.leader = lag_take(&memory, n);
    if (entries != NULL) {
        find_entries(s, entries, components);
    } else {
        lag_fill(kept, 0.0, s->pattern.first);
        lag_fill(kept, (double)n, s->pattern.end);
        lag_fill(kept, 0.0, s->components.component);
    }
    link_components(s, components);
}
