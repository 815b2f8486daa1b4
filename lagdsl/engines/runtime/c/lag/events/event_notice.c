#include "lag/event_notice.h"

#include "lag/equations/motion.h"

const char *lag_event_notice_name(const lag_model *model, const lag_event_notice *notice)
{
    const lag_places places = lag_places_of(model);
    const size_t which = notice->which;
    switch (notice->what) {
    case LAG_TICK:
        return model->discretes[places.clock + which].name;
    case LAG_TRUE:
    case LAG_FALSE:
    case LAG_JUMP:
        return model->discretes[places.relation + which].name;
    case LAG_OPENED:
    case LAG_CLOSED:
    case LAG_IMPACT:
        return model->constraints[model->contact_rows[which]].name;
    case LAG_SLIPS:
    case LAG_STICKS:
    case LAG_REVERSES:
        return model->frictions[which];
    case LAG_REINIT:
        return model->resets[which];
    case LAG_TERMINATE:
        return model->stops[which];
    case LAG_WARNING:
        return which < model->na ? model->assertions[which] : model->failures[which - model->na];
    case LAG_BEFORE:
    case LAG_AFTER:
        break;
    }
    return NULL;
}

const char *lag_event_kind_name(lag_event_kind what)
{
    static const char *const names[] = {
        "before", "tick", "true", "false", "opened", "closed", "impact", "reinit", "terminate", "after", "jump",
        "slips", "sticks", "reverses", "warning",
    };
    return (size_t)what < sizeof names / sizeof names[0] ? names[what] : "";
}
