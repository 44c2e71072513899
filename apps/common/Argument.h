// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace voxeland::apps
{
class CommandLine;

enum class Presence
{
    optional,
    required
};

/** What a command line may hold, with what was given; CommandLine::parse() fills it in. The kinds
 * are below. Made with
 *   - names: "-i,--input", "--strict", or "map" for the one that has its place instead of a name
 *   - value: what --help calls its value, as "FILE.rawlog"
 *   - description: for --help, without a full stop. */
class Argument
{
 public:
    Argument(const Argument&) = delete;
    Argument& operator=(const Argument&) = delete;
    virtual ~Argument() = default;

    [[nodiscard]] bool isSet() const { return m_isSet; }
    /** Its long name, for messages: "--input". */
    [[nodiscard]] const std::string& name() const { return m_name; }

 protected:
    explicit Argument(const std::string& names);

 private:
    friend class CommandLine;
    /** \param values what was given, at least one \throws ConfigurationError if that cannot be */
    virtual void take(const std::vector<std::string>& values) = 0;

    std::string m_name;
    bool m_isSet = false;
};

/** An option that is there or not. */
class Switch : public Argument
{
 public:
    Switch(CommandLine& line, const std::string& names, const std::string& description);

 private:
    void take(const std::vector<std::string>&) override {}
};

/** A switch that a text may follow: "--dump-config" or "--dump-config all". */
class SwitchOrText : public Argument
{
 public:
    SwitchOrText(CommandLine& line, const std::string& names, const std::string& value,
                 const std::string& description);

    /** Empty if no text was given. */
    [[nodiscard]] const std::string& value() const { return m_value; }

 private:
    void take(const std::vector<std::string>& values) override { m_value = values.front(); }

    std::string m_value;
};

/** A text, which may be empty. */
class Text : public Argument
{
 public:
    /** \param preset the value if none is given */
    Text(CommandLine& line, const std::string& names, const std::string& value,
         const std::string& description, std::string preset = "",
         Presence presence = Presence::optional);
    Text(CommandLine& line, const std::string& names, const std::string& value,
         const std::string& description, Presence presence);

    [[nodiscard]] const std::string& value() const { return m_value; }

 private:
    void take(const std::vector<std::string>& values) override { m_value = values.front(); }

    std::string m_value;
};

/** Texts: the option may be given repeatedly. */
class Texts : public Argument
{
 public:
    Texts(CommandLine& line, const std::string& names, const std::string& value,
          const std::string& description, Presence presence = Presence::optional);

    /** In the order given. */
    [[nodiscard]] const std::vector<std::string>& values() const { return m_values; }

 private:
    void take(const std::vector<std::string>& values) override { m_values = values; }

    std::vector<std::string> m_values;
};

/** The number that a text is, blanks around it allowed: finite, within the range of its type.
 *  \param name of the option, for the message \throws ConfigurationError if it is none */
template <typename N>
N numberOf(const std::string& name, const std::string& text);

/** A number: double, or whole numbers of a type; of one without a sign, none below 0. */
template <typename N>
class Number : public Argument
{
 public:
    /** \param preset the value if none is given */
    Number(CommandLine& line, const std::string& names, const std::string& value,
           const std::string& description, N preset);

    [[nodiscard]] N value() const { return m_value; }

 private:
    void take(const std::vector<std::string>& values) override
    {
        m_value = numberOf<N>(name(), values.front());
    }

    N m_value;
};
}  // namespace voxeland::apps
