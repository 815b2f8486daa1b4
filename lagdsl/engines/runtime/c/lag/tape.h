/*
 * A model as bytes: its functions as instructions that an interpreter runs (lag/tape/tape_code.h), with all else that lag_model holds.
 *
 * The bytes come from a file or from whoever made them; nothing of them is trusted before lag_tape_check() has seen every word.
 * Numbers are little-endian. Head: "lagtape\n", version, CRC-32 (of ISO 3309, as in PNG) of all that follows the head, and the
 * length of that in 64 bits. Then the lengths of the sections, in bytes, 64 bits each, and the sections in the order of lag_tape_section,
 * each from a multiple of 8 bytes on.
 *
 * The functions of one state work on a row of doubles, which is the workspace: constants, parameters, what follows from
 * parameters alone (prepare() fills these), and what belongs to the function that runs.
 */
#ifndef LAG_TAPE_H
#define LAG_TAPE_H

#include "lag/model.h"
#include "lag/parallel.h"

#define LAG_TAPE_VERSION 15u

/* The sections, with the type of their entries. */
typedef enum lag_tape_section {
    LAG_TAPE_SIZES,          /* uint32: see lag_tape_size */
    LAG_TAPE_CONSTANT_POOL,  /* double */
    LAG_TAPE_DEFAULTS,       /* double (np) */
    LAG_TAPE_POSITION_LEVEL, /* bytes (nc) */
    LAG_TAPE_REDUNDANT,      /* bytes (nc) */
    LAG_TAPE_KINDS,          /* bytes (nw) */
    LAG_TAPE_STRICT,         /* bytes (nindicator) */
    LAG_TAPE_JUMPING,        /* bytes (nindicator) */
    LAG_TAPE_WHOLE_INPUTS,   /* bytes (nu), or nothing */
    LAG_TAPE_ONE_WAY,        /* bytes (ncontact), or nothing */
    LAG_TAPE_KEPT_ROWS,      /* uint32 (nk) */
    LAG_TAPE_CONTACT_ROWS,   /* uint32 (ncontact) */
    LAG_TAPE_FRICTION_ROWS,  /* uint32 (nslip) */
    LAG_TAPE_FRICTION_SLIPS, /* uint32 (nfriction) */
    LAG_TAPE_FRICTION_CONTACTS, /* uint32 (nfriction) */
    LAG_TAPE_SWITCHED_ROWS,  /* uint32 (nswitched) */
    LAG_TAPE_RESET_PLACES,   /* uint32 (nreset) */
    LAG_TAPE_JACOBIAN_ROWS,  /* uint32: where J can be nonzero; or nothing */
    LAG_TAPE_JACOBIAN_COLUMNS, /* uint32, as many */
    LAG_TAPE_RESPONSE_ROWS,  /* the same of the responses to the rows that are kept, */
    LAG_TAPE_RESPONSE_COLUMNS,
    LAG_TAPE_COUPLING_ROWS,  /* and of their products with these rows */
    LAG_TAPE_COUPLING_COLUMNS,
    LAG_TAPE_EQUATIONS_ROWS, /* the same of the equations, see lag_patterns, */
    LAG_TAPE_EQUATIONS_COLUMNS,
    LAG_TAPE_EQUATIONS_PLACES, /* uint32 (nq + nz + nc), (2 nq + nz) and (nq + nc); or nothing */
    LAG_TAPE_EQUATIONS_GROUPS,
    LAG_TAPE_EQUATIONS_VALUE_GROUPS,
    LAG_TAPE_COMPONENTS,     /* uint32 (nq + nz), or nothing */
    LAG_TAPE_START_STATE,    /* double: the time and x (1 + 2 nq + nz), or nothing */
    LAG_TAPE_START_FIXED,    /* bytes (2 nq + nz), or nothing; so are those that follow */
    LAG_TAPE_START_WRITTEN,  /* bytes (2 nq + nz) */
    LAG_TAPE_START_NOMINAL,  /* double (2 nq + nz) */
    LAG_TAPE_START_MINIMUM,  /* double (nq) */
    LAG_TAPE_START_MAXIMUM,  /* double (nq) */
    LAG_TAPE_START_FREE,     /* bytes (np) */
    LAG_TAPE_START_PARAMETER_NOMINAL, /* double (np) */
    LAG_TAPE_START_PARAMETER_MINIMUM, /* double (np) */
    LAG_TAPE_START_PARAMETER_MAXIMUM, /* double (np) */
    LAG_TAPE_SLOTS,          /* uint32 (slots, 3): name, unit and place as first bytes of texts; the place may be 2^32 - 1: none */
    LAG_TAPE_MESSAGES,       /* uint32: assertions (na), frictions (nfriction), resets (nreset), stops (nstop), failures (nfail), as first bytes of texts */
    LAG_TAPE_TEXTS,          /* bytes, every text ended by a zero */
    /* uint32 (functions, 2): first word and number of words, which is zero where there is none: prepare(), those of lag_function,
     * then twice the members of lag_tangents, primal() or motion() first; then jacobian(), which may be left out */
    LAG_TAPE_FUNCTIONS,
    LAG_TAPE_WORDS,          /* uint32: the instructions */
    LAG_TAPE_SECTIONS
} lag_tape_section;

/* Entries of LAG_TAPE_SIZES, in this order: members of lag_model except the last ones. */
typedef enum lag_tape_size {
    LAG_TAPE_NQ,
    LAG_TAPE_NZ,
    LAG_TAPE_NU,
    LAG_TAPE_NW,
    LAG_TAPE_NP,
    LAG_TAPE_NC,
    LAG_TAPE_NY,
    LAG_TAPE_NI,
    LAG_TAPE_NA,
    LAG_TAPE_ND,
    LAG_TAPE_NE,
    LAG_TAPE_RANK,
    LAG_TAPE_NK,
    LAG_TAPE_NINDICATOR,
    LAG_TAPE_NCONTACT,
    LAG_TAPE_NGAP,
    LAG_TAPE_NCLOCK,
    LAG_TAPE_NRESET,
    LAG_TAPE_NCOLLISION,
    LAG_TAPE_NSTOP,
    LAG_TAPE_NFAIL,
    LAG_TAPE_NTIMED,
    LAG_TAPE_NDISTANCE,
    LAG_TAPE_NCORNER,
    LAG_TAPE_NWAY,
    LAG_TAPE_NTURN,
    LAG_TAPE_NDELAY,
    LAG_TAPE_NSLIP,
    LAG_TAPE_NFRICTION,
    LAG_TAPE_NLOAD,
    LAG_TAPE_NSWITCHED,
    LAG_TAPE_NINERTIAL,
    LAG_TAPE_NPLACE,
    LAG_TAPE_NAXES,
    LAG_TAPE_NTWIST,
    LAG_TAPE_ROW,      /* length of the row */
    LAG_TAPE_PREPARED, /* of these, how many prepare() fills */
    /* of the functions of several directions, of states and inputs, then of parameters: the part of the row that they share, as
     * prepare() and their primal() leave it, and the length of the row of their own; zero: there are none */
    LAG_TAPE_SHARED,
    LAG_TAPE_ALONG_ROW,
    LAG_TAPE_PARAMETER_SHARED,
    LAG_TAPE_PARAMETER_ALONG_ROW,
    LAG_TAPE_NAME,     /* first byte of the name of the model among the texts */
    LAG_TAPE_NUMBER_OF_SIZES
} lag_tape_size;

/*
 * Looks at `bytes` (count), on an address that is a multiple of 8. LAG_OK: they are a tape, and *memory tells how many bytes the
 * model takes. LAG_BAD_STATE_DATA: they are none, of another version, or were changed.
 */
lag_status lag_tape_check(const void *bytes, size_t count, size_t *memory);

/*
 * The model of a tape that was checked, in `memory`, on an address that is a multiple of 8. It refers to `bytes`, which must stay as long as
 * it does. Copies of it work as well.
 */
const lag_model *lag_tape_model(const void *bytes, size_t count, void *memory);

/* Its functions of several states at once; null where the compiler has no vectors. */
const lag_states *lag_tape_states(const lag_model *model);

/* Its functions of several directions at once, of states and inputs or of parameters; null where the tape has none. */
const lag_tangents *lag_tape_tangents(const lag_model *model, int parameters);

/* jacobian() and nothing else; null where the tape has none. */
const lag_tangents *lag_tape_jacobian(const lag_model *model);

/* Start of the motion of such a model; null if its tape does not contain one. */
const lag_start *lag_tape_start(const lag_model *model);

#endif
