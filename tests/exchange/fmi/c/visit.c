/* Calls at random on the generated model that this is linked with, by both versions: see random_calls.h. Arguments: seed, lives. */
#include "random_calls.h"

int main(int count, char **arguments)
{
    CHECK(count == 3);
    const unsigned lives = (unsigned)strtoul(arguments[2], NULL, 10);
    for (int version = 2; version <= 3; ++version) {
        CHECK(visit_at_random(strtoull(arguments[1], NULL, 10), lives, version) > 20 * lives);
    }
    return 0;
}
