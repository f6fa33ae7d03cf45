#include "inputs/lattices.hpp"

#include "inputs/set_parts.hpp"

namespace circumspect::generators {

std::vector<Point> cubic_lattice_points(Dice& dice, std::size_t dimension, Count count) {
  return set_of(dice, count, [&] { return integer_point(dice, dimension, 3); });
}

std::vector<Point> body_centred_lattice_points(Dice& dice, std::size_t dimension, Count count) {
  return set_of(dice, count, [&] {
    Point x = integer_point(dice, dimension, 3);
    const Rational offset = Rational(dice.within(0, 1)) / 2;
    for (Rational& c : x) c += offset;
    return x;
  });
}

std::vector<Point> face_centred_lattice_points(Dice& dice, std::size_t dimension, Count count) {
  return set_of(dice, count, [&] {
    Point x = integer_point(dice, dimension, 3);
    Rational sum = 0;
    for (const Rational& c : x) sum += c;
    if (Rational(sum / 2).get_den() != 1) x.back() += sign(x.back()) < 0 ? 1 : -1;
    return x;
  });
}

std::vector<Point> hexagonal_lattice_points(Dice& dice, std::size_t dimension, Count count) {
  return set_of(dice, count, [&] {
    const double half_of_root_three = 0x1.bb67ae8584caap-1;
    Point x = integer_point(dice, dimension, 3);
    const Rational row = x[1];
    x[0] += row / 2;
    x[1] = exact_value(row.get_d() * half_of_root_three);
    return x;
  });
}

}  // namespace circumspect::generators
