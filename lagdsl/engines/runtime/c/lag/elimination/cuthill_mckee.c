/* Source: see lag/elimination/band.h. */
#include "lag/elimination/band.h"

/* A graph whose nodes are the rows. Numbers are doubles: a workspace is of one type. */
typedef struct graph {
    size_t n;
    double *start;    /* (n + 1) of the neighbours of each node */
    double *neighbor; /* (n (n - 1)) at most */
    double *mark;     /* (n) the last search that came by */
    double searches;
} graph;

/* Nodes of a connected part by their distance from the first one. */
typedef struct levels {
    size_t count;  /* nodes */
    size_t last;   /* the first one at the largest distance */
    size_t depth;  /* that distance */
} levels;

size_t lag_cuthill_mckee_memory(size_t n)
{
    return n * n + 2 * n + 1;
}

static size_t degree(const graph *g, size_t node)
{
    return (size_t)(g->start[node + 1] - g->start[node]);
}

static graph graph_of(size_t n, const double *a, double *memory)
{
    graph g = {n, memory, memory + n + 1, memory + n * n + n + 1, 0.0};
    size_t count = 0;
    for (size_t i = 0; i < n; ++i) {
        g.start[i] = (double)count;
        g.mark[i] = 0.0;
        for (size_t j = 0; j < n; ++j) {
            if (j != i && (a[i * n + j] != 0.0 || a[j * n + i] != 0.0)) {
                g.neighbor[count++] = (double)j;
            }
        }
    }
    g.start[n] = (double)count;
    return g;
}

/* The node moves ahead of those from `first` on that have more neighbours. */
static void insert(const graph *g, double *queue, size_t first, size_t at)
{
    const double node = queue[at];
    for (; at > first && degree(g, (size_t)queue[at - 1]) > degree(g, (size_t)node); --at) {
        queue[at] = queue[at - 1];
    }
    queue[at] = node;
}

/* The part of `root` into `queue`, breadth first, neighbours of one node by increasing degree. */
static levels search(graph *g, size_t root, double *queue)
{
    levels found = {1, 0, 0};
    size_t end = 1; /* of the nodes at the present distance */
    g->searches += 1.0;
    queue[0] = (double)root;
    g->mark[root] = g->searches;
    for (size_t k = 0; k < found.count; ++k) {
        if (k == end) {
            found.last = end;
            end = found.count;
            ++found.depth;
        }
        const size_t node = (size_t)queue[k];
        const size_t first = found.count;
        for (size_t i = (size_t)g->start[node]; i < (size_t)g->start[node + 1]; ++i) {
            const size_t next = (size_t)g->neighbor[i];
            if (g->mark[next] != g->searches) {
                g->mark[next] = g->searches;
                queue[found.count] = (double)next;
                insert(g, queue, first, found.count++);
            }
        }
    }
    return found;
}

/* The part of `root`, from a node on that is as far from another as searches find. */
static size_t number(graph *g, size_t root, double *queue)
{
    levels found = search(g, root, queue);
    for (;;) {
        size_t far = (size_t)queue[found.last];
        for (size_t k = found.last; k < found.count; ++k) {
            far = degree(g, (size_t)queue[k]) < degree(g, far) ? (size_t)queue[k] : far;
        }
        const levels next = search(g, far, queue);
        if (next.depth <= found.depth) {
            return next.count;
        }
        found = next;
    }
}

void lag_cuthill_mckee(size_t n, const double *a, double *order, double *memory)
{
    graph g = graph_of(n, a, memory);
    size_t count = 0;
    for (size_t node = 0; node < n; ++node) {
        count += g.mark[node] == 0.0 ? number(&g, node, order + count) : 0;
    }
    for (size_t k = 0; 2 * k + 1 < n; ++k) {
        const double kept = order[k];
        order[k] = order[n - 1 - k];
        order[n - 1 - k] = kept;
    }
}
