/*
 * The state of a run as bytes: no pointers among them, so they may be taken back at another address, by another run of the same model
 * with the same options, in another process. It goes on bit by bit as the first one would have. The workspace of the model is left out, as
 * it holds what prepare() writes and nothing else: so another filling of the same equations that rounds alike, such as compiled C for a
 * tape, takes the bytes too.
 *
 * Options, parameters behind them and what callbacks point to belong to the caller, who saves them beside it if they change. Parameters that
 * come back after lag_run_load() are to be prepared then (lag_motion_parameters).
 */
#ifndef LAG_SERIALIZATION_H
#define LAG_SERIALIZATION_H

#include "lag/linalg/record.h"
#include "lag/run.h"

/* A number that is the same in any two runs that may take each other's bytes: of the model's name and sizes, and of the options'. */
unsigned long long lag_run_signature(const lag_model *model, const lag_run_options *options);

/* Of bytes; any change of a few of them changes it. */
unsigned long long lag_record_sum(const unsigned char *bytes, size_t count);

/* All of a run; parameters are taken from its options again where they have been prepared. After reading, the model is to be prepared. */
void lag_run_record(lag_run *run, lag_record *record);

/* The same with signature and sum around it. Any alignment does. */
size_t lag_run_saved_size(const lag_model *model, const lag_run_options *options);
void lag_run_save(const lag_run *run, unsigned char *bytes);
/* LAG_BAD_STATE_DATA: the run stays as it is. Another status is that of prepare(). */
lag_status lag_run_load(lag_run *run, const unsigned char *bytes);

#endif
