// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/base/numbers.h>
#include <waker/statistics/estimates.h>
#include <waker/statistics/event_tree.h>

#include <algorithm>

namespace Waker
{
  namespace
  {
    /// 0 if the condition never occurred: that branch has no weight.
    double
    share(const std::uint64_t count, const std::uint64_t n)
    {
      return n == 0 ? 0. : static_cast<double>(count) / n;
    }
  } // namespace


  std::vector<SlideSequence>
  slide_sequences(const std::vector<Record>             &records,
                  const std::vector<std::vector<Slide>> &slides)
  {
    AssertDimension(records.size(), slides.size());
    std::vector<SlideSequence> sequences;
    sequences.reserve(records.size());
    for (std::size_t i = 0; i < records.size(); ++i)
      if (counts(records[i]))
        {
          const bool floods = records[i].flooding_time >= 0.;
          const bool fails  = floods || records[i].failed();
          const auto n      = static_cast<unsigned int>(slides[i].size());
          sequences.push_back({std::max(n, fails ? 1U : 0U), floods});
        }
    return sequences;
  }


  EventTree
  build_event_tree(const std::vector<SlideSequence> &sequences,
                   const unsigned int                length)
  {
    Assert(length >= 1, dealii::ExcInternalError());
    unsigned int  n_levels = 0;
    std::uint64_t n_floods = 0;
    for (const SlideSequence &sequence : sequences)
      {
        Assert(sequence.n_slides > 0 || !sequence.floods,
               dealii::ExcMessage("Flooding needs a slide"));
        n_levels = std::max(n_levels, sequence.n_slides);
        n_floods += sequence.floods;
      }

    EventTree tree;
    tree.levels.resize(n_levels);
    for (const SlideSequence &sequence : sequences)
      for (unsigned int j = 1; j <= sequence.n_slides; ++j)
        {
          ++tree.levels[j - 1].n_slides;
          tree.levels[j - 1].n_flooding +=
            sequence.floods && j == sequence.n_slides;
        }

    std::uint64_t n_reached = sequences.size(), n_flooded = 0;
    std::uint64_t n_truncated = 0;
    double        standing = 1., cumulative = 0.; // (4.22)
    tree.length         = length;
    tree.truncated      = 0.;
    tree.critical_slide = 0;
    tree.critical_path  = nan;
    double slides_only  = 1.; // product of P(S_k | notF_{k-1})
    for (unsigned int j = 1; j <= n_levels; ++j)
      {
        EventTreeLevel &level = tree.levels[j - 1];
        level.n_reached       = n_reached;
        level.slide           = share(level.n_slides, level.n_reached);
        level.flooding        = share(level.n_flooding, level.n_slides);
        level.path = level.flooding * level.slide * standing; // (4.21)

        if (j < length)
          tree.truncated += level.path;
        else if (j == length)
          tree.truncated += level.slide * standing;
        n_truncated += j < length    ? level.n_flooding
                       : j == length ? level.n_slides
                                     : 0;

        slides_only *= level.slide;
        if (tree.critical_slide == 0 && level.flooding > 0.5)
          {
            tree.critical_slide = j;
            tree.critical_path  = slides_only;
          }

        cumulative += level.path;
        standing *= (1. - level.flooding) * level.slide; // (4.20)
        level.cumulative = cumulative;
        level.standing   = standing;
        n_flooded += level.n_flooding;
        level.interval = clopper_pearson(n_flooded, sequences.size());
        n_reached      = level.n_slides - level.n_flooding;
      }
    tree.probability      = cumulative;
    tree.direct           = proportion(n_floods, sequences.size());
    tree.truncated_direct = proportion(n_truncated, sequences.size());
    return tree;
  }
} // namespace Waker
