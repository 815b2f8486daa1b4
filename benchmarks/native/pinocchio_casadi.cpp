// Pinocchio's articulated-body algorithm on CasADi's expressions, generated as C: pinocchio_casadi MODEL FOLDER NAME.
#include <pinocchio/autodiff/casadi.hpp>

#include <iostream>
#include <pinocchio/multibody.hpp>
#include <pinocchio/algorithm/aba.hpp>

#include "pinocchio_model.hpp"

namespace pin = pinocchio;
using Scalar = casadi::SX;
using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

static Vector of(const Scalar &x)
{
    Vector v(x.size1());
    for (int i = 0; i < x.size1(); ++i) {
        v[i] = x(i);
    }
    return v;
}

int main(int count, char **arguments)
{
    if (count != 4) {
        return 2;
    }
    const pin::ModelTpl<Scalar> model = read_model(arguments[1]).cast<Scalar>();
    pin::DataTpl<Scalar> data(model);
    const Scalar q = Scalar::sym("q", model.nv), v = Scalar::sym("v", model.nv);
    pin::aba(model, data, of(q), of(v), Vector(Vector::Constant(model.nv, Scalar(0))), pin::Convention::LOCAL);
    Scalar qdd = Scalar::zeros(model.nv, 1);
    for (int i = 0; i < model.nv; ++i) {
        qdd(i) = data.ddq[i];
    }
    casadi::Function f("f", {q, v}, {qdd});
    casadi::CodeGenerator generator(arguments[3]);
    generator.add(f);
    generator.generate(std::string(arguments[2]) + "/");
    std::cout << f.n_instructions() << std::endl;
    return 0;
}
