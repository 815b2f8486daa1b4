/* Contestants: a library that enters functions of a state, all timed in turns by contest.c. */
#ifndef CONTEST_H
#define CONTEST_H

#ifdef __cplusplus
extern "C" {
#endif

typedef struct contestant {
    const char *kind;    /* what is computed: forward, jacobian, batch */
    const char *variant; /* how, where there are several ways; else "" */
    void (*call)(void *context, int state);
    void (*fetch)(void *context, int state, double *results); /* of the last call, which was at that state */
    void *context;
    int count; /* of results */
    int each;  /* evaluations in one call */
} contestant;

/* q and qd, each n numbers, of state k from states + 2 n k on. */
typedef struct field {
    const double *states;
    int rows, n;
    void (*add)(contestant one);
} field;

/* Every library defines this. Returns 0, or something else after it has told why. */
int enter(const field *of, int count, char **arguments);

#ifdef __cplusplus
}
#endif
#endif
