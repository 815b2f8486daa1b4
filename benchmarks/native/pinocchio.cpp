// Pinocchio's forward dynamics and its derivatives: MODEL, as serial.py writes it.
#include "contest.h"

#include "pinocchio_model.hpp"
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/aba-derivatives.hpp>

namespace pin = pinocchio;
using Vector = Eigen::VectorXd;
using View = Eigen::Ref<const Vector>;

struct Context {
    pin::Model model;
    pin::Data data;
    std::vector<Vector> q, v;
    Vector tau;
};

static void aba_world(void *context, int k)
{
    Context &c = *static_cast<Context *>(context);
    pin::aba(c.model, c.data, View(c.q[k]), View(c.v[k]), View(c.tau), pin::Convention::WORLD);
}

static void aba_local(void *context, int k)
{
    Context &c = *static_cast<Context *>(context);
    pin::aba(c.model, c.data, View(c.q[k]), View(c.v[k]), View(c.tau), pin::Convention::LOCAL);
}

static void derivatives(void *context, int k)
{
    Context &c = *static_cast<Context *>(context);
    pin::computeABADerivatives(c.model, c.data, View(c.q[k]), View(c.v[k]), View(c.tau));
}

static void fetch_forward(void *context, int, double *results)
{
    const Context &c = *static_cast<Context *>(context);
    Vector::Map(results, c.model.nv) = c.data.ddq;
}

static void fetch_derivatives(void *context, int, double *results)
{
    const Context &c = *static_cast<Context *>(context);
    const int n = c.model.nv;
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> map(results, n, 2 * n);
    map.leftCols(n) = c.data.ddq_dq;
    map.rightCols(n) = c.data.ddq_dv;
}

extern "C" int enter(const field *of, int count, char **arguments)
{
    if (count != 2) {
        return 1;
    }
    Context *c = new Context;
    c->model = read_model(arguments[0]);
    c->data = pin::Data(c->model);
    const int n = c->model.nv;
    c->tau = Vector::Zero(n);
    for (int k = 0; k < of->rows; ++k) {
        c->q.push_back(Vector::Map(of->states + 2 * n * k, n));
        c->v.push_back(Vector::Map(of->states + 2 * n * k + n, n));
    }
    of->add({"forward", "_local", aba_local, fetch_forward, c, n, 1});
    of->add({"forward", "_world", aba_world, fetch_forward, c, n, 1});
    if (std::string(arguments[1]) == "jacobian") {
        of->add({"jacobian", "", derivatives, fetch_derivatives, c, 2 * n * n, 1});
    }
    return 0;
}
