/* FMI 2.0: values of variables. Every variable is one number. */
#include "lag/fmi2/fmi2.h"

#define LAG_FMI_ROOM
#define LAG_FMI_COUNT n

typedef fmi2Boolean lag_fmi_boolean_bits;

#include "lag/shell/value_functions.h"

LAG_VALUES(Real, LAG_TYPE_REAL, NULL, NULL)
LAG_VALUES(Integer, LAG_TYPE_INTEGER, store_integer, fetch_integer)
