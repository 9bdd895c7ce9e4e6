#include "framework/grading/message.h"

#include "framework/base/error.h"
#include "framework/base/json.h"
#include "framework/base/json_reader.h"

#include <algorithm>

namespace luch::grading {
namespace {

std::string word_of(const JsonValue& object, std::string_view key) {
    const auto value = object.member(key);
    return std::string(value ? value->text().value_or("") : "");
}

}  // namespace

std::string text_of(const CaseResult& result) {
    Json signature = Json::array(), pictures = Json::array();
    const Finding& finding = result.finding;
    for (const std::uint32_t element :
         finding.signature.empty() ? finding.wrong : finding.signature) {
        signature.push(std::uint64_t{element});
    }
    for (const std::string& file : result.pictures) pictures.push(file);
    return Json::object()
        .set("status", static_cast<int>(result.status))
        .set("what", result.finding.what)
        .set("first", result.finding.first)
        .set("pixel", result.finding.pixel)
        .set("signature", signature)
        .set("pictures", pictures)
        .text();
}

CaseResult result_of(const std::string& text) {
    const CaseResult damaged{Status::crashed, failure("crashed: its answer cannot be read"), {}};
    try {
        const JsonDocument document(text, "answer");
        const JsonValue root = document.root();
        const auto status = root.member("status"), signature = root.member("signature"),
                   pictures = root.member("pictures");
        if (!status || !status->number() || !signature || !pictures) return damaged;
        CaseResult result;
        result.status = static_cast<Status>(static_cast<int>(*status->number()));
        result.finding.passed = result.status == Status::pass;
        result.finding.what = word_of(root, "what");
        result.finding.first = word_of(root, "first");
        result.finding.pixel = word_of(root, "pixel");
        for (std::size_t i = 0; i < signature->size(); ++i) {
            const double element = signature->at(i).number().value_or(0);
            result.finding.signature.push_back(static_cast<std::uint32_t>(element));
        }
        std::sort(result.finding.signature.begin(), result.finding.signature.end());
        for (std::size_t i = 0; i < pictures->size(); ++i) {
            result.pictures.emplace_back(pictures->at(i).text().value_or(""));
        }
        return result;
    } catch (const Error&) {
        return damaged;
    }
}

}  // namespace luch::grading
