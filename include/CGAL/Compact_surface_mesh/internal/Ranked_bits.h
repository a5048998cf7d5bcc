// Copyright (c) 2026  The Compact_surface_mesh authors.
// All rights reserved.
//
// This file is part of Compact_surface_mesh, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

#ifndef CGAL_COMPACT_SURFACE_MESH_INTERNAL_RANKED_BITS_H
#define CGAL_COMPACT_SURFACE_MESH_INTERNAL_RANKED_BITS_H

#include <CGAL/license/Compact_surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace internal {

// A bit vector with rank in constant and select in logarithmic time (in practice constant,
// where ones are spread evenly), for 1.2 bits per bit.
class Ranked_bits
{
public:
  Ranked_bits() = default;

  template <class Predicate>
  Ranked_bits(std::size_t size, const Predicate& is_set)
    : m_words(size / 64 + 1, 0), m_count_before(m_words.size() / words_per_block + 2, 0)
  {
    for (std::size_t i = 0; i < size; ++i)
      if (is_set(i))
        m_words[i / 64] |= std::uint64_t(1) << (i % 64);
    std::size_t count = 0;
    for (std::size_t w = 0; w < m_words.size(); ++w) {
      if (w % words_per_block == 0)
        m_count_before[w / words_per_block] = count;
      count += popcount(m_words[w]);
    }
    const std::size_t num_blocks = (m_words.size() - 1) / words_per_block + 1;
    m_count_before.resize(num_blocks + 1);
    m_count_before[num_blocks] = count;
    for (std::size_t block = 0; block < num_blocks; ++block)
      while (m_block_of_one.size() * ones_per_sample < m_count_before[block + 1])
        m_block_of_one.push_back(block);
    m_block_of_one.push_back(num_blocks);
    m_count_before.shrink_to_fit();
    m_block_of_one.shrink_to_fit();
  }

  // whether it has no bits at all
  bool empty() const { return m_words.empty(); }

  std::size_t count() const { return m_count_before.empty() ? 0 : m_count_before.back(); }

  bool operator[](std::size_t i) const { return (m_words[i / 64] >> (i % 64)) & 1; }

  // the number of ones before position i
  std::size_t rank(std::size_t i) const
  {
    const std::size_t word = i / 64, block = word / words_per_block;
    std::size_t result = m_count_before[block];
    for (std::size_t w = block * words_per_block; w < word; ++w)
      result += popcount(m_words[w]);
    return result + popcount(m_words[word] & ((std::uint64_t(1) << (i % 64)) - 1));
  }

  // the position of the one with i ones before it; i < count()
  std::size_t select(std::size_t i) const
  {
    const auto begin = m_count_before.begin();
    const std::size_t sample = i / ones_per_sample;
    const auto block = std::upper_bound(begin + m_block_of_one[sample] + 1,
                                        begin + (std::min)(m_block_of_one[sample + 1] + 1, m_count_before.size()), i) - 1;
    std::size_t left = i - *block;
    std::size_t w = static_cast<std::size_t>(block - begin) * words_per_block;
    for (std::size_t n; left >= (n = popcount(m_words[w])); ++w)
      left -= n;
    return 64 * w + select_in_word(m_words[w], left);
  }

  std::size_t bytes() const
  {
    return 8 * m_words.capacity() + sizeof(std::size_t) * (m_count_before.capacity() + m_block_of_one.capacity());
  }

private:
  enum : std::size_t { words_per_block = 8, ones_per_sample = 512 };

  // These two add the bits of all bytes at once (D. E. Knuth, The Art of Computer Programming, volume 4A, section
  // 7.1.3): without special instructions, compilers call a function that looks bytes up.

  static constexpr std::uint64_t in_each_byte(std::uint64_t b) { return b * 0x0101010101010101u; }

  // In byte k, the number of ones in bytes 0 to k.
  static std::uint64_t byte_sums(std::uint64_t word)
  {
    word -= (word >> 1) & in_each_byte(0x55);
    word = (word & in_each_byte(0x33)) + ((word >> 2) & in_each_byte(0x33));
    return in_each_byte((word + (word >> 4)) & in_each_byte(0x0f));
  }

  static std::size_t popcount(std::uint64_t word) { return byte_sums(word) >> 56; }

  // The position of the one with `left` ones before it.
  static std::size_t select_in_word(std::uint64_t word, std::size_t left)
  {
    const std::uint64_t sums = byte_sums(word);
    const std::uint64_t is_before = ((in_each_byte(left) | in_each_byte(0x80)) - sums) & in_each_byte(0x80);
    const std::size_t shift = 8 * (in_each_byte(is_before >> 7) >> 56);
    word >>= shift;
    for (left -= (sums << 8) >> shift & 0xff; left > 0; --left)
      word &= word - 1;
    return shift + popcount((word & (~word + 1)) - 1);
  }

  std::vector<std::uint64_t> m_words;
  std::vector<std::size_t> m_count_before; // of each block, and at last of all
  std::vector<std::size_t> m_block_of_one; // the block of every 512th one
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_COMPACT_SURFACE_MESH_INTERNAL_RANKED_BITS_H
