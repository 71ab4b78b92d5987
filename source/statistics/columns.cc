// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/numbers.h>
#include <waker/statistics/columns.h>


namespace Waker
{
  namespace
  {
    /// A record has -1 for a time at which nothing happened.
    double
    time_or_nan(const double time)
    {
      return time < 0. ? nan : time;
    }


    /// Nothing that moved has no mean displacement.
    double
    displacement(const MovedSoil &soil, const double value)
    {
      return soil.area > 0. ? value : nan;
    }


    /// Of a slope that has not slid there is nothing to say.
    double
    of_slide(const SlopeSlide &slide, const double MovingBody::*const member)
    {
      return slide.time < 0. ? nan : slide.body.*member;
    }


    using A = AnalysedRecord;


    /// -1: not known.
    std::int8_t
    flag(const A &a, bool Unrest::*const which)
    {
      return a.record->unrest ? (*a.record->unrest).*which : -1;
    }
  } // namespace



  const std::vector<Column<AnalysedRecord, double>> real_columns = {
    {"initial_failure_time",
     "s",
     "time of initial failure by width or height",
     [](const A &a) { return time_or_nan(a.record->initial_time); }},
    {"initial_failure_time_thesis",
     "s",
     "time at which the width is first below the initial one",
     [](const A &a) { return time_or_nan(a.record->initial_time_thesis); }},
    {"initial_failure_time_displacement",
     "s",
     "time at which a body is first seen to have moved",
     [](const A &a) {
       return time_or_nan(a.record->time_of(FailureReading::by_displacement));
     }},
    {"inner_slide_time",
     "s",
     "time at which a slide of the inner slope is seen, by displacement",
     [](const A &a) { return time_or_nan(a.record->inner_slide.time); }},
    {"inner_slide_area",
     "m2",
     "area of its body then",
     [](const A &a) {
       return of_slide(a.record->inner_slide, &MovingBody::area);
     }},
    {"inner_slide_share",
     "1",
     "share of the profile that this is",
     [](const A &a) {
       return of_slide(a.record->inner_slide, &MovingBody::share);
     }},
    {"inner_slide_crest_cut",
     "m",
     "x at which it cuts the crest",
     [](const A &a) {
       return of_slide(a.record->inner_slide, &MovingBody::crest_cut);
     }},
    {"outer_slide_time",
     "s",
     "time at which a slide of the outer slope is seen, by displacement",
     [](const A &a) { return time_or_nan(a.record->outer_slide.time); }},
    {"outer_slide_area",
     "m2",
     "area of its body then",
     [](const A &a) {
       return of_slide(a.record->outer_slide, &MovingBody::area);
     }},
    {"outer_slide_share",
     "1",
     "share of the profile that this is",
     [](const A &a) {
       return of_slide(a.record->outer_slide, &MovingBody::share);
     }},
    {"outer_slide_crest_cut",
     "m",
     "x at which it cuts the crest",
     [](const A &a) {
       return of_slide(a.record->outer_slide, &MovingBody::crest_cut);
     }},
    {"flooding_time",
     "s",
     "time of flooding",
     [](const A &a) { return time_or_nan(a.record->flooding_time); }},
    {"end_time",
     "s",
     "time at which the realisation stopped",
     [](const A &a) { return a.record->end_time; }},
    {"initial_width",
     "m",
     "initial width of the dyke at the water level",
     [](const A &a) { return a.record->initial_width; }},
    {"initial_height",
     "m",
     "initial height of the dyke",
     [](const A &a) { return a.record->initial_height; }},
    {"residual_width",
     "m",
     "width of the dyke at the end",
     [](const A &a) { return a.record->residual_width; }},
    {"residual_height",
     "m",
     "height of the dyke at the end",
     [](const A &a) { return a.record->residual_height; }},
    {"width_after_first_slide",
     "m",
     "width of the dyke after the first slide",
     [](const A &a) { return a.slides.empty() ? nan : a.slides[0].width; }},
    {"height_after_first_slide",
     "m",
     "height of the dyke after the first slide",
     [](const A &a) { return a.slides.empty() ? nan : a.slides[0].height; }},

    {"inward_area",
     "m2",
     "area of soil moved inward by more than 0.5 m, at the end",
     [](const A &a) { return a.record->inward.area; }},
    {"inward_dx",
     "m",
     "its mean horizontal displacement",
     [](const A &a) {
       return displacement(a.record->inward, a.record->inward.dx);
     }},
    {"inward_dy",
     "m",
     "its mean vertical displacement",
     [](const A &a) {
       return displacement(a.record->inward, a.record->inward.dy);
     }},
    {"outward_area",
     "m2",
     "area of soil moved outward by more than 0.5 m, at the end",
     [](const A &a) { return a.record->outward.area; }},
    {"outward_dx",
     "m",
     "its mean horizontal displacement",
     [](const A &a) {
       return displacement(a.record->outward, a.record->outward.dx);
     }},
    {"outward_dy",
     "m",
     "its mean vertical displacement",
     [](const A &a) {
       return displacement(a.record->outward, a.record->outward.dy);
     }},
    {"first_inward_area",
     "m2",
     "area of soil moved inward by more than 0.5 m, 1 s after initial failure",
     [](const A &a) {
       return a.record->failed() ? a.record->first_inward.area : nan;
     }},
    {"first_inward_dx",
     "m",
     "its mean horizontal displacement",
     [](const A &a) {
       return displacement(a.record->first_inward, a.record->first_inward.dx);
     }},
    {"first_inward_dy",
     "m",
     "its mean vertical displacement",
     [](const A &a) {
       return displacement(a.record->first_inward, a.record->first_inward.dy);
     }},
    {"first_outward_area",
     "m2",
     "area of soil moved outward by more than 0.5 m, 1 s after initial failure",
     [](const A &a) {
       return a.record->failed() ? a.record->first_outward.area : nan;
     }},
    {"first_outward_dx",
     "m",
     "its mean horizontal displacement",
     [](const A &a) {
       return displacement(a.record->first_outward, a.record->first_outward.dx);
     }},
    {"first_outward_dy",
     "m",
     "its mean vertical displacement",
     [](const A &a) {
       return displacement(a.record->first_outward, a.record->first_outward.dy);
     }},

    {"mean_strength",
     "kPa",
     "mass average of the first random field (degrees if it is an angle)",
     [](const A &a) { return a.record->mean_strength; }},
    {"least_strength",
     "kPa",
     "least value of the first random field (degrees if it is an angle)",
     [](const A &a) { return a.record->least_strength; }},
    {"wall_time",
     "s",
     "time that the computer took",
     [](const A &a) { return a.record->wall_time; }},
    {"field_time", "s", "of which for the random fields", [](const A &a) {
       return a.record->field_time;
     }}};



  const std::vector<Column<AnalysedRecord, std::int8_t>> flag_columns = {
    {"outcome",
     "1",
     "how the realisation ended",
     [](const A &a) { return static_cast<std::int8_t>(a.record->outcome); },
     "stable initial_failure flooding numerical_failure still_moving "
     "loads_still_change stopped_by_the_box"},
    {"failure_class",
     "1",
     "how the dyke failed",
     [](const A &a) { return static_cast<std::int8_t>(a.failure_class); },
     "none initial_only retrogressive horizontal outer settled overflow"},
    {"still_moving",
     "1",
     "the dyke was not at rest at the end",
     [](const A &a) { return flag(a, &Unrest::moving); },
     "no yes"},
    {"loads_change",
     "1",
     "loads changed shortly before the end, or change after it",
     [](const A &a) { return flag(a, &Unrest::loads_change); },
     "no yes"},
    {"at_box",
     "1",
     "soil lay against a side of the box at the end",
     [](const A &a) { return flag(a, &Unrest::at_box); },
     "no yes"}};



  const std::vector<Column<AnalysedRecord, std::int32_t>> count_columns = {
    {"attempts",
     "1",
     "attempts, each but the first with a smaller time step",
     [](const A &a) { return static_cast<std::int32_t>(a.record->attempts); }},
    {"n_slides", "1", "number of slides", [](const A &a) {
       return static_cast<std::int32_t>(a.slides.size());
     }}};



  const std::vector<Column<AnalysedRecord, std::int64_t>> work_columns = {
    {"steps",
     "1",
     "time steps",
     [](const A &a) { return static_cast<std::int64_t>(a.record->steps); }},
    {"newton_iterations",
     "1",
     "Newton iterations",
     [](const A &a) {
       return static_cast<std::int64_t>(a.record->newton_iterations);
     }},
    {"linear_iterations",
     "1",
     "linear iterations",
     [](const A &a) {
       return static_cast<std::int64_t>(a.record->linear_iterations);
     }},
    {"unconverged_steps",
     "1",
     "time steps that did not converge",
     [](const A &a) {
       return static_cast<std::int64_t>(a.record->unconverged_steps);
     }},
    {"points_beyond_law",
     "1",
     "points at which the draw gave what their law would refuse; -1: not known",
     [](const A &a) {
       return a.record->points_beyond_law
                ? static_cast<std::int64_t>(*a.record->points_beyond_law)
                : std::int64_t(-1);
     }}};



  const std::vector<Column<Slide, double>> slide_columns = {
    {"slide_start",
     "s",
     "start of the slide",
     [](const Slide &s) { return s.start; }},
    {"slide_end",
     "s",
     "end of the slide",
     [](const Slide &s) { return s.end; }},
    {"slide_width",
     "m",
     "width of the dyke after the slide",
     [](const Slide &s) { return s.width; }},
    {"slide_height",
     "m",
     "height of the dyke after the slide",
     [](const Slide &s) { return s.height; }}};
} // namespace Waker
