// Pinocchio's forward dynamics and its derivatives in a C++ loop: pinocchio MODEL STATES, the model as serial.py writes it.
#include "bench.h"

#include <Eigen/Core>
#include <fstream>
#include <pinocchio/multibody.hpp>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/aba-derivatives.hpp>

namespace pin = pinocchio;
using Vector = Eigen::VectorXd;
using View = Eigen::Ref<const Vector>;

static pin::Model read_model(const char *path)
{
    std::ifstream file(path);
    pin::Model model;
    int count;
    double x, y, z;
    file >> count >> x >> y >> z;
    model.gravity.linear(Eigen::Vector3d(x, y, z));
    for (int i = 0; i < count; ++i) {
        Eigen::Matrix3d rotation, inertia;
        Eigen::Vector3d place, center;
        double mass, xx, yy, zz, xy, xz, yz;
        for (int k = 0; k < 9; ++k) {
            file >> rotation(k / 3, k % 3);
        }
        file >> place[0] >> place[1] >> place[2] >> mass >> center[0] >> center[1] >> center[2];
        file >> xx >> yy >> zz >> xy >> xz >> yz;
        inertia << xx, xy, xz, xy, yy, yz, xz, yz, zz;
        const auto joint = model.addJoint((pin::JointIndex)i, pin::JointModelRZ(), pin::SE3(rotation, place), "j" + std::to_string(i));
        model.appendBodyToJoint(joint, pin::Inertia(mass, center, inertia), pin::SE3::Identity());
    }
    return model;
}

struct Context {
    pin::Model model;
    pin::Data data;
    Vector q[STATES], v[STATES], tau;
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

int main(int, char **arguments)
{
    Context c;
    c.model = read_model(arguments[1]);
    c.data = pin::Data(c.model);
    const int n = c.model.nv;
    const double *states = read_states(arguments[2], STATES, 2 * n);
    c.tau = Vector::Zero(n);
    for (int k = 0; k < STATES; ++k) {
        c.q[k] = Vector::Map(states + 2 * n * k, n);
        c.v[k] = Vector::Map(states + 2 * n * k + n, n);
    }
    for (int k = 0; k < STATES; ++k) {
        aba_local(&c, k);
        show("forward", k, c.data.ddq.data(), n);
    }
    bench("aba_local", aba_local, &c);
    bench("aba_world", aba_world, &c);
    bench("derivatives", derivatives, &c);
    return 0;
}
