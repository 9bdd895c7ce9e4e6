// The tests that hold a step against the reference's outputs, and the list of them all.
#include "homework/ldr/check/tests.h"

#include "homework/ldr/check/same_words.h"

#include <any>

namespace luch::homework::ldr {
namespace {

using grading::Finding;

/// A case for every sample.
std::vector<grading::Case> cases_of(const Samples& samples, SampleTest test) {
    std::vector<grading::Case> cases;
    for (const auto& sample : samples) {
        cases.push_back({sample->name, "", [sample, test](const std::any& steps) {
                             return test(*std::any_cast<Steps>(&steps), *sample);
                         }});
    }
    return cases;
}

Finding encodes(const Steps& steps, const Sample& sample) {
    std::vector<Word> words(sample.light.size());
    Misfits misfits;
    steps.encode(sample.light, sample.exposure, words, misfits);
    return same_words(words, sample.encoded);
}

Finding adds(const Steps& steps, const Sample& sample) {
    std::vector<Word> words = sample.a;
    steps.add(words, sample.b);
    return same_words(words, sample.added);
}

Finding modulates(const Steps& steps, const Sample& sample) {
    std::vector<Word> words = sample.a;
    steps.modulate(words, sample.b);
    return same_words(words, sample.modulated);
}

Finding mixes(const Steps& steps, const Sample& sample) {
    std::vector<Word> words = sample.a;
    steps.mix(words, sample.b, sample.up);
    return same_words(words, sample.mixed);
}

Finding lerps(const Steps& steps, const Sample& sample) {
    std::vector<Word> words = sample.a;
    steps.lerp(words, sample.b, sample.alpha);
    return same_words(words, sample.lerped);
}

Finding accumulates(const Steps& steps, const Sample& sample) {
    std::vector<Wide> sums = sample.sums;
    steps.accumulate(sample.a, sums);
    return same_sums(sums, sample.accumulated);
}

Finding resolves(const Steps& steps, const Sample& sample) {
    std::vector<Word> words(sample.sums.size());
    steps.resolve(sample.sums, sample.n, sample.dither, words);
    return same_words(words, sample.resolved);
}

}  // namespace

grading::Task encode_task(const Samples& samples) {
    return {"ldr.t1",
            "encode: light becomes a word",
            {{"ldr.t1.words", 3, cases_of(samples, encodes)},
             {"ldr.t1.counts_misfits", 1, cases_of(samples, counts_misfits)}}};
}

grading::Task add_task(const Samples& samples) {
    return {"ldr.t2",
            "add: no more than white",
            {{"ldr.t2.words", 2, cases_of(samples, adds)},
             {"ldr.t2.no_carry", 1, cases_of(samples, no_carry)},
             {"ldr.t2.black_adds_nothing", 1, cases_of(samples, black_adds_nothing)}}};
}

grading::Task modulate_task(const Samples& samples) {
    return {"ldr.t3",
            "modulate: light times colour",
            {{"ldr.t3.words", 2, cases_of(samples, modulates)},
             {"ldr.t3.white_changes_nothing", 1, cases_of(samples, white_changes_nothing)},
             {"ldr.t3.all_pairs", 1, cases_of(samples, all_pairs)}}};
}

grading::Task mix_task(const Samples& samples) {
    return {"ldr.t4",
            "mix: half and half",
            {{"ldr.t4.words", 2, cases_of(samples, mixes)},
             {"ldr.t4.half_of_the_same", 1, cases_of(samples, half_of_the_same)},
             {"ldr.t4.no_bias", 1, cases_of(samples, no_bias)}}};
}

grading::Task lerp_task(const Samples& samples) {
    return {"ldr.t5",
            "lerp: one colour over another",
            {{"ldr.t5.words", 3, cases_of(samples, lerps)},
             {"ldr.t5.from_end_to_end", 1, cases_of(samples, from_end_to_end)}}};
}

grading::Task accumulate_task(const Samples& samples) {
    return {"ldr.t6",
            "accumulate: room for sums",
            {{"ldr.t6.sums", 2, cases_of(samples, accumulates)},
             {"ldr.t6.sixty_four_layers", 1, cases_of(samples, sixty_four_layers)}}};
}

grading::Task resolve_task(const Samples& samples) {
    return {"ldr.t7",
            "resolve: from light to the screen",
            {{"ldr.t7.words", 4, cases_of(samples, resolves)},
             {"ldr.t7.many_are_as_one", 1, cases_of(samples, many_are_as_one)}}};
}

}  // namespace luch::homework::ldr
