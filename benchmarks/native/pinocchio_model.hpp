// A Pinocchio model from numbers, as serial.py writes them.
#pragma once
#include <Eigen/Core>
#include <fstream>
#include <string>
#include <pinocchio/multibody.hpp>

inline pinocchio::Model read_model(const char *path)
{
    std::ifstream file(path);
    pinocchio::Model model;
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
        const auto joint = model.addJoint(
            (pinocchio::JointIndex)i, pinocchio::JointModelRZ(), pinocchio::SE3(rotation, place), "j" + std::to_string(i));
        model.appendBodyToJoint(joint, pinocchio::Inertia(mass, center, inertia), pinocchio::SE3::Identity());
    }
    return model;
}
