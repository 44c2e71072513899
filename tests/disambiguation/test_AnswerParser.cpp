// SPDX-License-Identifier: BSD-3-Clause
/** Answers as models and people give them, with what a person reading them would take them for. */
#include "voxeland/disambiguation/AnswerParser.h"
#include "voxeland/disambiguation/Thoughts.h"

#include <gtest/gtest.h>

using namespace voxeland;

namespace
{
using Names = std::vector<std::string>;

/** The candidate an answer is understood as, "unknown", or "-" if it is not. */
std::string understood(const std::string& answer, const Names& candidates)
{
    std::vector<RankedCategory> ranked;
    for (size_t i = 0; i < candidates.size(); ++i)
        ranked.push_back({static_cast<category_id_t>(i), candidates[i], 0.1});
    const auto category = categoryNamedBy(answer, ranked);
    if (!category) return "-";
    return *category == UNKNOWN_CATEGORY_ID ? UNKNOWN_CATEGORY : candidates.at(*category);
}

const Names FURNITURE = {"chair", "couch", "dining table", "bed",  "TV",
                         "bench", "table", "potted plant", "book", "knife"};

/** An answer and what it says. */
struct Case
{
    const char* answer;
    const char* means;
};

void expectUnderstood(const std::vector<Case>& cases, const Names& candidates = FURNITURE)
{
    for (const auto& [answer, means] : cases)
        EXPECT_EQ(understood(answer, candidates), means) << answer;
}
}  // namespace

TEST(AnswerParser, theFormThatIsAskedFor)
{
    expectUnderstood({
        {"The object category is chair", "chair"},
        {"The object category is dining table.", "dining table"},
        {"the OBJECT category is: tv\n", "TV"},
        {"The object category is unknown", "unknown"},
        {"The object category is a chair.", "chair"},
        {"The object category is a chair!", "chair"},
        {"The object category is the potted plant", "potted plant"},
        {"The object category is \"Dining Table\".", "dining table"},
        {"The object category is <chair>", "chair"},
        {"The object category is [chair].", "chair"},
        {"The object category is 'chair'", "chair"},
        {"The object's category is chair.", "chair"},
        {"The category of the object is chair.", "chair"},
        {"The category of this object is a couch.", "couch"},
        {"The correct category is couch.", "couch"},
        {"The most likely category would be couch.", "couch"},
        {"THE OBJECT CATEGORY IS DINING TABLE", "dining table"},
        {"The object category is:\n\n**chair**", "chair"},
        {"Sure! The object category is chair", "chair"},
        {"It has no legs and is not a tv.\n\nThe object category is table.\n", "table"},
        {"The object category is tv. Yes: the object category is TV!", "TV"},
    });
}

TEST(AnswerParser, aReasonMayFollow)
{
    expectUnderstood({
        {"The object category is chair because of its shape and legs.", "chair"},
        {"The object category is dining table, as it has a flat top.", "dining table"},
        {"The object category is chair since a couch would be wider.", "chair"},
        {"The object category is chair - it has a backrest and four legs.", "chair"},
        {"The object category is chair — it has a backrest.", "chair"},
        {"The object category is chair (confidence: high).", "chair"},
        {"The object category is chair with 90% confidence", "chair"},
        {"The object category is chair, given its backrest.", "chair"},
        {"The object category is chair and it has four legs.", "chair"},
        {"The object category is chair based on the pictures", "chair"},
        {"The object category is chair\n\nThe shape fits best. A couch is behind it.", "chair"},
        {"The object category is chair The shape fits best.", "chair"},
        {"The object category is chair, not couch.", "chair"},
        {"The object category is chair rather than couch.", "chair"},
        {"The object category is chair instead of a couch", "chair"},
        {"Chair. It stands next to a table.", "chair"},
        {"**Chair**\n\nThe outlined object has a seat and stands between the couch and the table.",
         "chair"},
        {"This is a chair. There is a table beside it.", "chair"},
        {"The object in the pictures is a dining table, which is surrounded by chairs.",
         "dining table"},
        {"The object category is couch (also known as sofa).", "couch"},
        {"The most probable category is chair, followed by couch.", "chair"},
        {"It has four legs, unlike a couch, and is next to the table. Therefore, it is a chair.",
         "chair"},
        {"It is not wide enough for a couch, so I would say chair.", "chair"},
    });
}

TEST(AnswerParser, otherWordsForTheSame)
{
    expectUnderstood({
        {"chair", "chair"},
        {"Table", "table"},
        {"chair.", "chair"},
        {"A couch.", "couch"},
        {"This is a chair.", "chair"},
        {"It's a chair.", "chair"},
        {"It is most likely a couch", "couch"},
        {"That looks like a bench to me.", "bench"},
        {"The object appears to be a dining table.", "dining table"},
        {"The outlined object is a potted plant on a table.", "potted plant"},
        {"I would say: a dining table.", "dining table"},
        {"I'd go with chair.", "chair"},
        {"I would classify this as a couch.", "couch"},
        {"I think it is a chair", "chair"},
        {"Answer: **chair**", "chair"},
        {"**Answer:** chair", "chair"},
        {"Final answer: chair", "chair"},
        {"My answer is couch", "couch"},
        {"Category: chair\nConfidence: 0.92\nReasoning: unlike a couch it has one seat", "chair"},
        {"Object category: chair", "chair"},
        {"category = chair", "chair"},
        {"Answer - chair", "chair"},
        {"Category → chair", "chair"},
        {"Answer: B) couch", "couch"},
        {"2. couch", "couch"},
        {"(b) couch", "couch"},
        {"# Answer\n\nchair", "chair"},
        {"- chair", "chair"},
        {"> chair", "chair"},
        {"The object category is definitely a chair.", "chair"},
        {"The object category is best described as a chair.", "chair"},
        {"The object category is a wooden chair.", "chair"},
        {"The object category is office chair.", "chair"},
        {"Yes, it is a chair.", "chair"},
        {"In the picture I see a chair.", "chair"},
        {"A photograph of a chair.", "chair"},
        {"It is a kind of bench.", "bench"},
        {"Based on the images, the object category is a chair.", "chair"},
        {"The category of the outlined object is chair.", "chair"},
        {"Answer: The outlined object is a chair. A couch stands next to it.", "chair"},
        {"Answer: It is a chair. A couch stands next to it.", "chair"},
        {"After careful analysis: couch", "couch"},
        {"The object is classified as chair", "chair"},
        {"The object is most consistent with a chair.", "chair"},
        {"It resembles a chair.", "chair"},
        {"sofa (couch)", "couch"},
        {"OBJECT_CATEGORY=chair", "chair"},
        {"chair chair chair", "chair"},
        {"None of the categories match; it is a giraffe.", "unknown"},
        {"The object category is none of the given candidates (chair, couch).", "unknown"},
        {"None of these.", "unknown"},
        {"It is none of the above.", "unknown"},
        {"unknown", "unknown"},
        {"Unknown.", "unknown"},
    });
}

TEST(AnswerParser, namesAreWrittenInManyWays)
{
    expectUnderstood({
        {"The object category is dining_table", "dining table"},
        {"The object category is dining-table", "dining table"},
        {"The object category is diningtable", "dining table"},
        {"The object category is DiningTable.", "dining table"},
        {"The object category is dining\u00a0table", "dining table"},
        {"The object category is dining\u2011table", "dining table"},
        {"The object category is chairs.", "chair"},
        {"The object category is dining tables", "dining table"},
        {"The object category is benches", "bench"},
        {"The object category is knives", "knife"},
        {"Couches", "couch"},
        {"The object category is T.V.", "TV"},
        {"The object category is tv_1", "TV"},
        {"\uff34\uff28\uff25 object category is \uff43\uff48\uff41\uff49\uff52\u3002", "chair"},
        {"The object category is \u201cchair\u201d.", "chair"},
        {"The object category is \u2018chair\u2019", "chair"},
        {"\u00abchair\u00bb", "chair"},
        {"The\u00a0object\u00a0category\u00a0is\u00a0chair", "chair"},
        {"The object category is\u3000chair", "chair"},
        {"The object category is \u200bchair\u200b", "chair"},
        {"\ufeffThe object category is chair", "chair"},
        {"The object category is chair \U0001FA91", "chair"},
        {"tablet", "-"},
        {"The object category is armchair", "-"},
        {"The object category is bedroom", "-"},
        {"The object category is tablecloth", "-"},
    });
}

TEST(AnswerParser, aNameWithinAnotherDoesNotCount)
{
    expectUnderstood({
        {"The object category is dining table", "dining table"},
        {"The object category is table", "table"},
        {"The object category is table lamp", "-"},
        {"The object category is chair leg", "-"},
        {"The object category is bed frame.", "-"},
        {"table lamp", "-"},
        {"This is a table lamp.", "-"},
        {"a dining table or a table", "-"},
    });
    const Names screens = {"tv", "tv monitor", "monitor", "bed", "bedroom", "plant", "pottedplant"};
    expectUnderstood({{"The object category is tv monitor", "tv monitor"},
                      {"The object category is TVMonitor", "tv monitor"},
                      {"The object category is tv", "tv"},
                      {"The object category is monitor.", "monitor"},
                      {"The object category is tv, monitor", "-"},
                      {"bedroom", "bedroom"},
                      {"bed", "bed"},
                      {"The object category is bed room", "bedroom"},
                      {"potted plant", "pottedplant"},
                      {"The object category is a plant", "plant"}},
                     screens);
    expectUnderstood({{"The object category is TV monitor", "tvmonitor"},
                      {"The object category is sofa/couch", "sofa/couch"},
                      {"The object category is glasses", "glasses"},
                      {"The object category is glass", "glass"},
                      {"The object category is curtain", "curtains"},
                      {"The object category is people", "person"}},
                     {"tvmonitor", "sofa/couch", "glass", "glasses", "curtains", "person"});
}

TEST(AnswerParser, marksOfTemplatesAndFormatsAreNoMatter)
{
    expectUnderstood({
        {"The object category is chair</s>", "chair"},
        {"The object category is chair<|im_end|>", "chair"},
        {"The object category is chair<|eot_id|>", "chair"},
        {"The object category is chair<end_of_turn>", "chair"},
        {"<s> The object category is chair.</s>", "chair"},
        {"<bos>chair<eos>", "chair"},
        {"<|im_start|>assistant\nThe object category is chair<|im_end|>", "chair"},
        {"<start_of_turn>model\nchair<end_of_turn>", "chair"},
        {"ASSISTANT: The object category is chair", "chair"},
        {"[/INST] The object category is chair", "chair"},
        {"### Response:\nchair", "chair"},
        {"chair<|im_end|>\n<|im_start|>user\nIs it a couch?", "chair"},
        {"The object category is <ref>chair</ref><box>(102,40),(310,512)</box>", "chair"},
        {"<|object_ref_start|>chair<|object_ref_end|><|box_start|>(1,2),(3,4)<|box_end|>", "chair"},
        {"<|begin_of_box|>chair<|end_of_box|>", "chair"},
        {"The object category is \\boxed{chair}", "chair"},
        {"It could be a couch, but it is narrow. $\\boxed{\\text{dining table}}$", "dining table"},
        {"\\boxed{chair}.", "chair"},
        {"<answer>chair</answer>", "chair"},
        {"<answer> The object category is chair. </answer>", "chair"},
        {"A couch is wider. <answer>chair</answer>", "chair"},
        {"<SUMMARY>A couch or a chair.</SUMMARY><CONCLUSION>chair</CONCLUSION>", "chair"},
        {"**The object category is chair**", "chair"},
        {"The object category is `chair`.", "chair"},
        {"*The object category is __chair__*", "chair"},
        {"{\"object_category\": \"chair\"}", "chair"},
        {"```json\n{\"category\": \"dining table\", \"confidence\": 0.87}\n```", "dining table"},
        {"{\"answer\": \"chair\", \"reason\": \"A couch would have room for two.\"}", "chair"},
        {"[{\"bbox_2d\": [1, 2, 3, 4], \"label\": \"chair\"}]", "chair"},
        {"{'category': 'chair'}", "chair"},
        {"{\"answer\": \"The object category is chair.\"}", "chair"},
        {"```\nThe object category is chair\n```", "chair"},
        {"category: chair", "chair"},
        {"<category>chair</category>", "chair"},
    });
}

TEST(AnswerParser, thoughtsAreNoAnswers)
{
    expectUnderstood({
        {"<think>Maybe a bench? Maybe not.</think>\nThe object category is chair", "chair"},
        {"<thinking>Could be a bed or a chair.</thinking>\nThe object category is chair", "chair"},
        {"I might say \"The object category is bed\".\n</think>\n\nThe object category is chair",
         "chair"},
        {"<|channel>thought\nA bench? a bed? No.<channel|>The object category is chair", "chair"},
        {"<|channel|>analysis<|message|>Could be bed.<|end|><|start|>assistant<|channel|>final"
         "<|message|>The object category is chair<|return|>",
         "chair"},
        {"analysisCould be a bed. Not sure.assistantfinalThe object category is chair", "chair"},
        {"[THINK]a bed[/THINK]chair", "chair"},
        {"\u25c1think\u25b7a bed\u25c1/think\u25b7chair", "chair"},
        {"<reasoning>The object category is bed?</reasoning><answer>chair</answer>", "chair"},
        {"The object category is chair <think>or a bed?</think>", "chair"},
        {"The object category is chair\n<think>or a bed", "chair"},
        {"<think>The object category is bed", "-"},
        {"<|channel|>analysis<|message|>The object category is bed", "-"},
    });
    EXPECT_EQ(withoutThoughts("<Think>a</Think> b <think>c"), "b");
    EXPECT_EQ(withoutThoughts("a</think>b</think> c"), "c");
    EXPECT_EQ(withoutThoughts(" no thoughts "), "no thoughts");
}

TEST(AnswerParser, whatIsDeniedIsNotNamed)
{
    expectUnderstood({
        {"The object category is not a chair but a couch.", "couch"},
        {"It is not a chair, it is a couch.", "couch"},
        {"Not a chair but a couch", "couch"},
        {"It's a couch, not a chair.", "couch"},
        {"It looks more like a couch than a chair.", "couch"},
        {"Unlike a couch, it has one seat. It is a chair.", "chair"},
        {"No, it is a chair.", "chair"},
        {"It isn't a table or a bed; it is a chair", "chair"},
        {"The object category is not table", "-"},
        {"It is not a table", "-"},
        {"It isn't a tv", "-"},
        {"It isn’t a tv", "-"},
        {"I do not think it is a chair", "-"},
        {"It doesn't look like a couch.", "-"},
        {"I cannot tell whether this is a chair.", "-"},
        {"Neither a chair nor a couch.", "-"},
        {"It is not only a chair but a couch", "-"},
        {"It is anything except a couch", "-"},
        {"non-chair", "-"},
        {"No chair", "-"},
        {"Not a chair. Not a couch. It must be a bed.", "bed"},
    });
}

TEST(AnswerParser, nothingIsGuessedAmongSeveral)
{
    expectUnderstood({
        {"The object category is table or tv", "-"},
        {"The object category is chair/couch", "-"},
        {"The object category is chair, couch", "-"},
        {"The object category is chair and couch", "-"},
        {"The object category is chair (or couch)", "-"},
        {"The object category is chair, possibly a couch", "-"},
        {"The object category is chair - or maybe a couch.", "-"},
        {"The object category is chair or stool", "-"},
        {"The object category is either a chair or a couch", "-"},
        {"either a chair or a couch", "-"},
        {"The object category is table. The object category is tv.", "-"},
        {"The object category is chair. It could also be a couch.", "-"},
        {"The object category is chair. Alternatively, couch.", "-"},
        {"\\boxed{chair} or \\boxed{couch}", "-"},
        {"Answer:\n- chair\n- couch", "-"},
        {"chair\ncouch", "-"},
        {"1. chair\n2. couch", "-"},
        {"{\"category\": [\"chair\", \"couch\"]}", "-"},
        {"{\"chair\": 0.6, \"couch\": 0.4}", "-"},
        {"chair: 0.60\ncouch: 0.40", "-"},
        {"table, tv", "-"},
        {"chair|couch", "-"},
        {"A cross between a chair and a couch", "-"},
        {"unknown; a table?", "-"},
        {"The object category is chair or unknown", "-"},
        {"Possibly a chair, possibly a couch.", "-"},
        {"It could be a chair.", "-"},
        {"Chair?", "-"},
        {"The object category might be chair", "-"},
        {"The object category is a table maybe", "-"},
        {"Half chair, half couch", "-"},
        {"It is between a chair and a couch", "-"},
        {"The object category is chair; the object is a couch.", "-"},
        {"It is a chair. No wait, it is a couch.", "-"},
        {"The object category is chair. Actually, it is a couch.", "-"},
        {"The object category is chair, but it could be a couch.", "-"},
        {"Chair - no, couch.", "-"},
        {"Class: chair (0.93), Class: couch (0.05)", "-"},
        {"Option A: chair\nOption B: couch", "-"},
        {"It's a chair or a couch, probably a chair.", "-"},
    });
}

TEST(AnswerParser, somethingElseIsNoCandidate)
{
    expectUnderstood({
        {"", "-"},
        {" \n", "-"},
        {"The object category is", "-"},
        {"The object category is <category>", "-"},
        {"The object category is giraffe", "-"},
        {"The object category is a giraffe. It stands on a table.", "-"},
        {"a giraffe", "-"},
        {"The picture shows a giraffe on a table.", "-"},
        {"It stands beside the couch.", "-"},
        {"It is next to a wooden chair.", "-"},
        {"The leg of a table.", "-"},
        {"I'm sorry, I can't help with that.", "-"},
        {"The image is too blurry to tell.", "-"},
        {"The object category is clear.", "-"},
        {"\xff\xfe\x80", "-"},
    });
}

TEST(AnswerParser, otherLanguagesAroundANameAreUnderstood)
{
    expectUnderstood({
        {"Die Objektkategorie ist chair.", "chair"},
        {"La catégorie de l'objet est dining table.", "dining table"},
        {"La categoría del objeto es couch.", "couch"},
        {"物体类别是chair。", "chair"},
        {"答案：chair", "chair"},
        {"Das ist kein chair", "-"},
        {"Ce n'est pas une chair", "-"},
        {"不是chair", "-"},
        {"chairではない", "-"},
        {"chair oder couch", "-"},
        {"Die Objektkategorie ist Stuhl.", "-"},
    });
    expectUnderstood({{"物体类别是椅子。", "椅子"},
                      {"不是椅子", "-"},
                      {"The object category is Stühle", "-"},
                      {"The object category is STÜHLE", "-"},
                      {"La catégorie est CANAPÉ.", "canapé"}},
                     {"椅子", "沙发", "canapé"});
}

TEST(AnswerParser, theFinalAnswerOverrulesWhatIsSaidBefore)
{
    expectUnderstood({
        {"The object category is bed at first sight. Final answer: chair", "chair"},
        {"Looking at the pictures, it is not a bed.\nFinal answer: The object category is chair",
         "chair"},
        {"Final answer: chair. Final answer: couch", "-"},
        {"Candidates: chair, couch, bed. The answer is couch.", "couch"},
        {"It may be a bed or a chair. The object category is chair.", "chair"},
    });
}

TEST(AnswerParser, whatIsRepeatedManyTimesEnds)
{
    for (const std::string part : {"(",
                                   ":",
                                   "\n",
                                   ":(",
                                   "not ",
                                   "no\n",
                                   "answer: ",
                                   "answer:\n",
                                   "category is of the ",
                                   "it is ",
                                   "a the ",
                                   "chair or ",
                                   "on a wooden ",
                                   "<answer>",
                                   "<a>",
                                   "<think></think>",
                                   "</think>",
                                   "<think>",
                                   "so, ",
                                   "1) ",
                                   "final answer ",
                                   "\\boxed{",
                                   "maybe chair, "})
    {
        std::string answer;
        while (answer.size() < 300000) answer += part;
        understood(answer, FURNITURE);
        EXPECT_EQ(
            understood("<think>" + answer + "</think>\nThe object category is couch", FURNITURE),
            "couch")
            << part;
    }
}

TEST(AnswerParser, ofALongAnswerTheEndCounts)
{
    const std::string words(LONGEST_ANSWER, 'x');
    EXPECT_EQ(understood("chair\n" + words, FURNITURE), "-");
    EXPECT_EQ(understood(words + "\nThe object category is chair", FURNITURE), "chair");
}
