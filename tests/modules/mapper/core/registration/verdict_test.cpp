#include "modules/mapper/core/registration/verdict.h"

#include <gtest/gtest.h>

namespace scanway::registration {
namespace {

/// Of scans that agree as well as scans do.
Evidence best_evidence() {
  Evidence e;
  e.agreement = {0.95, 0.95, 0.0, 0.9};
  e.tracked = true;
  e.held_fit = 0.9;
  e.facing = 1000.0;
  e.sigma_m = e.sigma_rad = 0.0005;
  e.matches = 3000;
  return e;
}

RegistrationResult decided(const Evidence& evidence) {
  RegistrationResult result;
  decide(evidence, result);
  return result;
}

TEST(Verdict, IsSureOfScansThatAgreeInEverything) {
  const RegistrationResult result = decided(best_evidence());
  EXPECT_EQ(result.verdict, Verdict::accepted);
  EXPECT_GT(result.probability, 0.99);
}

TEST(Verdict, IsNotSureOfAPoseThatFewSurfacesHold) {
  Evidence e = best_evidence();
  double last = 0.0;
  for (const double facing : {0.0, 1.0, 3.0, 6.0, 12.0, 40.0, 1000.0}) {
    e.facing = facing;
    const double p = probability_right(e);
    EXPECT_GT(p, last);
    EXPECT_LE(p, 1.0 - 0.5 / (facing + 1.0));
    last = p;
  }
}

TEST(Verdict, IsLessSureTheMoreSpeaksAgainst) {
  const double p = probability_right(best_evidence());
  Evidence conflict = best_evidence(), rival = best_evidence(), vague = best_evidence(), few = best_evidence();
  conflict.agreement.conflict = 0.05;
  rival.margin = 0.0;
  vague.sigma_m = 0.05;
  few.matches = 20;
  for (const Evidence& e : {conflict, rival, vague, few}) EXPECT_LT(probability_right(e), p);
}

TEST(Verdict, RefusesWhatRestsOnTooLittleHoweverWellItFits) {
  Evidence e = best_evidence();
  e.agreement.overlap_back = 0.28;  // one scan sees a small part of the other
  EXPECT_EQ(decided(e).verdict, Verdict::refused);
  e = best_evidence();
  e.agreement.conflict = 0.1;
  EXPECT_EQ(decided(e).verdict, Verdict::refused);
  RegistrationResult open;
  open.open_directions = {"slides along the scene, 0 degrees from x"};
  decide(best_evidence(), open);
  EXPECT_EQ(open.verdict, Verdict::refused);
  EXPECT_LT(open.probability, 0.5);
}

}  // namespace
}  // namespace scanway::registration
