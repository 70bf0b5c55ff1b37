#include "factor.hpp"

#include <algorithm>
#include <cstdint>

namespace glint::wide {
namespace {

/// The upper half of the 256-bit product.
Big upper_product(Big x, Big y) {
    const Big mask = ~std::uint64_t{0};
    const Big x0 = x & mask, x1 = x >> 64, y0 = y & mask, y1 = y >> 64;
    const Big middle = x1 * y0 + ((x0 * y0) >> 64);
    const Big other = x0 * y1 + (middle & mask);
    return x1 * y1 + (middle >> 64) + (other >> 64);
}

/// Products modulo an odd number below 2^127, of residues x 2^128 (P. L. Montgomery 1985).
class Montgomery {
public:
    explicit Montgomery(Big modulus) : modulus_(modulus), inverse_(modulus) {
        for (int i = 0; i < 7; ++i) inverse_ *= 2 - modulus * inverse_;  // Newton: 3 right bits, 6, .. 384
        one_ = (~Big{0} % modulus + 1) % modulus;
        square_ = one_;  // becomes 2^256 mod modulus
        for (int i = 0; i < 128; ++i) square_ = add(square_, square_);
    }

    Big one() const { return one_; }
    Big enter(Big x) const { return multiply(x % modulus_, square_); }
    Big add(Big x, Big y) const { return x >= modulus_ - y ? x - (modulus_ - y) : x + y; }
    Big multiply(Big x, Big y) const {
        const Big upper = upper_product(x, y);
        const Big reduction = upper_product(x * y * inverse_, modulus_);
        return upper >= reduction ? upper - reduction : upper + (modulus_ - reduction);
    }

private:
    Big modulus_;
    Big inverse_;  // of the modulus, modulo 2^128
    Big one_ = 0, square_ = 0;
};

/// Miller and Rabin, exact below 2^81 with the first 13 primes as bases (Sorenson, Webster 2015). Legal: odd, above 41.
bool is_prime(Big number) {
    const Montgomery m(number);
    Big odd = number - 1;
    int twos = 0;
    for (; odd % 2 == 0; odd /= 2) ++twos;
    const Big minus_one = number - m.one();
    for (const int base : {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41}) {
        Big power = m.one();
        Big square = m.enter(static_cast<Big>(base));
        for (Big rest = odd; rest != 0; rest /= 2) {
            if (rest % 2 == 1) power = m.multiply(power, square);
            square = m.multiply(square, square);
        }
        bool passes = power == m.one() || power == minus_one;
        for (int i = 1; i < twos && !passes; ++i) {
            power = m.multiply(power, power);
            passes = power == minus_one;
        }
        if (!passes) return false;
    }
    return true;
}

Big greatest_common_divisor(Big x, Big y) {
    while (y != 0) {
        const Big rest = x % y;
        x = y;
        y = rest;
    }
    return x;
}

/// A proper divisor of an odd composite number (Pollard's rho in the form of Brent 1980).
Big proper_divisor(Big number) {
    const Montgomery m(number);
    for (Big constant = 1;; ++constant) {  // another sequence when one finds nothing but the number itself
        const Big c = m.enter(constant);
        const auto step = [&](Big x) { return m.add(m.multiply(x, x), c); };
        constexpr std::uint64_t block = 128;
        Big y = m.enter(2), x = y, start_of_block = y, product = m.one(), found = 1;
        for (std::uint64_t round = 1; found == 1; round *= 2) {
            x = y;
            for (std::uint64_t i = 0; i < round; ++i) y = step(y);
            for (std::uint64_t done = 0; done < round && found == 1; done += block) {
                start_of_block = y;
                for (std::uint64_t i = 0; i < std::min(block, round - done); ++i) {
                    y = step(y);
                    product = m.multiply(product, x > y ? x - y : y - x);
                }
                found = greatest_common_divisor(product, number);
            }
        }
        if (found == number) {  // several divisors met in one block: take its steps one by one
            y = start_of_block;
            do {
                y = step(y);
                found = greatest_common_divisor(x > y ? x - y : y - x, number);
            } while (found == 1);
        }
        if (found != number) return found;
    }
}

void add_primes(Big number, std::vector<Big>& primes) {
    if (number == 1) return;
    if (is_prime(number)) {
        primes.push_back(number);
        return;
    }
    const Big divisor = proper_divisor(number);
    add_primes(divisor, primes);
    add_primes(number / divisor, primes);
}

}  // namespace

std::vector<Big> divisors(Big number) {
    std::vector<Big> primes;
    for (std::uint64_t p = 2; p < 1000; p += p == 2 ? 1 : 2) {
        for (; number % p == 0; number /= p) primes.push_back(p);
    }
    add_primes(number, primes);
    std::sort(primes.begin(), primes.end());

    std::vector<Big> out{1};
    std::size_t before = 0;  // the divisors from here on hold the last prime as often as it was seen
    for (std::size_t i = 0; i < primes.size(); ++i) {
        const bool repeated = i > 0 && primes[i] == primes[i - 1];
        const std::size_t begin = repeated ? before : 0, end = out.size();
        for (std::size_t k = begin; k < end; ++k) out.push_back(out[k] * primes[i]);
        before = end;
    }
    return out;
}

}  // namespace glint::wide
