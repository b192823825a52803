// A body rotates freely: the error of each method of integrating its orientation, against time.
#include <contact/figure.hpp>
#include <contact/quaternion.hpp>
#include <contact/rotation.hpp>
#include <contact/sine_cosine.hpp>
#include <numbers>

struct Input {
  double steps;             // for each second
  double angular_velocity;  // rad/s
  double shape;  // moment about the axis of symmetry over that about a perpendicular axis
  double angle;  // between the angular velocity and the axis of symmetry, at first, degrees
  double also;   // a fifth curve: 0 none, 1 Euler's matrix, orthonormalised, 2 one moment for all
                 // axes, the mean, with the exponential map
  double at;     // the time that is read off, s
};

inline constexpr std::size_t samples = 41;
inline constexpr double seconds = 10;

struct Output {
  double problem;
  std::array<double, samples> matrix, quaternion, exponential, midpoint;  // errors
  std::array<double, samples> other;                                      // of the fifth curve
  std::array<double, 5> read;                                             // the errors at the time
  double length;  // of Euler's matrix's longest column at the end
};

namespace {

using Matrix = contact::Matrix3<double>;

double between(const Matrix& got, const Matrix& right) {
  // For two rotations 2 sin(δ/2), where δ is the angle between them. Euler's matrix is no rotation.
  return (got - right).norm() / std::sqrt(2.0);
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  if (!(in.steps > 0) || !(in.shape > 0)) out.problem = contact::figure::not_positive;
  if (in.steps > 2000 || std::abs(in.angular_velocity) > 1e6 || in.shape > 1e6 ||
      std::abs(in.angle) > 360) {
    out.problem = contact::figure::too_large;
  }
  if (out.problem == 0 && (in.steps < 4 || in.shape < 1e-3)) {
    out.problem = contact::figure::too_small;
  }
  if (out.problem != 0) return out;

  using V = contact::Vector3<double>;
  const V moments(1, 1, in.shape);
  const auto turn = contact::sine_cosine(in.angle * std::numbers::pi / 180);
  const V momentum(turn.sine * in.angular_velocity, 0,
                   turn.cosine * in.angular_velocity * in.shape);
  const V as_sphere = momentum / (moments.sum() / 3);
  const contact::Quaternion<double> start;
  Matrix m = Matrix::Identity();
  contact::Quaternion<double> q;
  contact::Quaternion<double> x;
  contact::Quaternion<double> mid;
  Matrix orthonormal = Matrix::Identity();
  contact::Quaternion<double> sphere;
  const auto a_sample = std::floor(in.steps / 4);
  const double h = seconds / (samples - 1) / a_sample;
  const auto angular_velocity_of = [&](const Matrix& r) {
    return contact::free_angular_velocity<double>(momentum, moments, r);
  };
  const auto read_at = static_cast<std::size_t>(
      std::nearbyint(std::fmin(std::fmax(in.at, 0), seconds) / seconds * (samples - 1)));
  for (std::size_t k = 0; k < samples; ++k) {
    const double t = static_cast<double>(k) * seconds / (samples - 1);
    const Matrix right =
        contact::matrix_of(contact::free_top<double>(start, momentum, 1, in.shape, t));
    const double other = in.also == 1   ? between(orthonormal, right)
                         : in.also == 2 ? between(contact::matrix_of(sphere), right)
                                        : 0;
    const std::array<double, 5> error{between(m, right), between(contact::matrix_of(q), right),
                                      between(contact::matrix_of(x), right),
                                      between(contact::matrix_of(mid), right), other};
    out.matrix[k] = error[0];
    out.quaternion[k] = error[1];
    out.exponential[k] = error[2];
    out.midpoint[k] = error[3];
    out.other[k] = error[4];
    if (k == read_at) out.read = error;
    for (double step = 0; step < a_sample; ++step) {
      m = contact::matrix_step<double>(m, angular_velocity_of(m), h);
      // A matrix that has overflowed is left as it is.
      if (!(m.cwiseAbs().maxCoeff() < 1e30)) m = Matrix::Constant(1e30);
      q = contact::quaternion_step<double>(q, angular_velocity_of(contact::matrix_of(q)), h);
      x = contact::exponential_step<double>(x, angular_velocity_of(contact::matrix_of(x)), h);
      mid = contact::midpoint_step<double>(mid, momentum, moments, h);
      orthonormal = contact::orthonormalised<double>(
          contact::matrix_step<double>(orthonormal, angular_velocity_of(orthonormal), h));
      sphere = contact::exponential_step<double>(sphere, as_sphere, h);
    }
  }
  out.length = m.colwise().norm().maxCoeff();
  return out;
}

FIGURE(Input, FIELDS(steps, angular_velocity, shape, angle, also, at), Output,
       FIELDS(problem, matrix, quaternion, exponential, midpoint, other, read, length))
