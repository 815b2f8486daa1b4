/* What a function says about its own success. */
#ifndef LAG_STATUS_H
#define LAG_STATUS_H

typedef enum lag_status {
    LAG_OK = 0,
    LAG_SINGULAR = 1,    /* M is singular on the null space of J: some accelerations are not determined */
    LAG_NOT_FINITE = 2,  /* a value is infinite or not a number; results hold what came out */
    LAG_MISSING = 3      /* the model lacks this function */
} lag_status;

#endif
