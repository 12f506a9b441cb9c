// The discrete Fourier transform of a square.
#pragma once

#include <complex>
#include <span>

namespace vesper {

enum class FourierWay { forward, back };

/// In place: sums over all places of the value times exp(-2 pi i (u x + v y) / side), or back with exp(+...) and
/// 1 / side^2, so that back after forward changes nothing. By Cooley and Tukey's halving.
/// \param square row by row, side * side values
/// \param side a power of 2
/// Throws Error(argument) for another side or size.
void fourier_transform(std::span<std::complex<double>> square, std::size_t side, FourierWay way);

} // namespace vesper
