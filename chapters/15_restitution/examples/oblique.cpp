// A ball meets a level floor obliquely, and the results of common mistakes.
#include <contact/restitution.hpp>
#include <cstdio>

using Vector = contact::Vector3<double>;

void print(const char* name, const Vector& v, const Vector& before) {
  std::printf("%-28s (%4.1f, %4.1f) m/s, %3.0f %% of the energy\n", name, v.x(), v.z(),
              100 * v.squaredNorm() / before.squaredNorm());
}

int main() {
  const Vector v(3, 0, -4);  // m/s
  const Vector n(0, 0, 1);
  const double k = 0.5;
  const double along_normal = v.dot(n);
  print("before", v, v);
  print("v - (1 + k)(v.N)N", contact::after_bounce(v, n, k), v);
  print("the same again", contact::after_bounce(contact::after_bounce(v, n, k), n, k), v);
  print("-k v", Vector(-k * v), v);
  print("v - k (v.N)N", Vector(v - k * along_normal * n), v);
  const Vector away = contact::after_bounce(v, n, k);
  print("reflected while moving away", Vector(away - (1 + k) * away.dot(n) * n), v);
}
