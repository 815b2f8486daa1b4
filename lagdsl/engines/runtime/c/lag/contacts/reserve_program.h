/* The linear program of the reserves of one group (lag/contacts/reserve.h). */
#ifndef LAG_RESERVE_PROGRAM_H
#define LAG_RESERVE_PROGRAM_H

#include "lag/contacts/reserve.h"

/* Doubles of its work. */
size_t lag_reserve_program_memory(const lag_model *model);

/* The reserve of a group, into what lag/contacts/reserve.h tells; a group in which nothing sticks has none. */
void lag_reserve_find(lag_reserve *reserve, double group);

#endif
