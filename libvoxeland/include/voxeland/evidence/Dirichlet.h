// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace voxeland
{
/** Logarithmic derivative of the gamma function, psi(x), for x > 0; absolute error below 1e-10
 *  (recurrence psi(x) = psi(x+1) - 1/x up to x >= 10, then the asymptotic series: Abramowitz and
 *  Stegun 6.3.5 and 6.3.18). */
double digamma(double x);

/** How the uncertainty of a Dirichlet distribution is said in one number [nat]. */
enum class EntropyMeasure
{
    expected,  //!< exact expected Shannon entropy: psi(A+1) - sum_k a_k psi(a_k+1) / A
    paper,     //!< the paper's equation: psi(A) - sum_k a_k psi(a_k) / A (larger by (K-1)/A)
    mean       //!< Shannon entropy of the mean, a_k / A
};

/** Name as in the INI files. */
std::string toString(EntropyMeasure measure);
/** Inverse of toString(); throws std::invalid_argument for any other text. */
EntropyMeasure entropyMeasureFromString(const std::string& name);

/** Entropy of a Dirichlet distribution with these concentration parameters, A being their sum
 *  [nat]. Parameters that are zero take no part. Zero if fewer than two are positive.
 *  \param concentration non-negative */
double dirichletEntropy(const std::vector<double>& concentration, EntropyMeasure measure);

/** Shannon entropy -sum p ln p of a discrete distribution [nat]. */
double shannonEntropy(const std::vector<double>& probabilities);

/** Share of an opinion that rests on no evidence, W/(W+A), in [0,1]: subjective logic's
 *  uncertainty mass. 1 if both are zero.
 *  \param priorStrength W \param evidence A, the sum of all evidence */
double vacuity(double priorStrength, double evidence);
}  // namespace voxeland
