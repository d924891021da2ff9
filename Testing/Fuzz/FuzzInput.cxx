// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzInput.h"

#include <algorithm>
#include <cctype>
#include <cstring>

namespace orthoslices
{
namespace support
{
namespace
{
constexpr const char* Axes = "xyzw";
constexpr const char* LabelNames = "abc";
constexpr const char* PortNames = "pqr";

/// The place of a character in a list; -1 if it is not there.
int Find(const char* list, char c)
{
  const char* found = c == '\0' ? nullptr : std::strchr(list, c);
  return found == nullptr ? -1 : static_cast<int>(found - list);
}

bool IsDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Reads a text from the start to the end.
class Reader
{
public:
  explicit Reader(const std::string& text)
    : Text(text)
  {
  }

  FuzzInput Run()
  {
    while (this->Place < this->Text.size() && this->Input.Pieces.size() <= FuzzInput::MaxPieces)
    {
      const char c = this->Text[this->Place];
      if (c == '-' || IsDigit(c))
      {
        this->Numbers.push_back(this->ReadNumber());
        continue;
      }
      ++this->Place;
      this->Take(c);
    }
    this->Finish();
    this->Input.Pieces.resize(std::min(this->Input.Pieces.size(), FuzzInput::MaxPieces));
    return std::move(this->Input);
  }

private:
  void Take(char c)
  {
    std::vector<FuzzPiece>& pieces = this->Input.Pieces;
    if (Find(Axes, c) >= 0)
    {
      this->Finish();
      pieces.emplace_back();
      pieces.back().Axis = Find(Axes, c);
    }
    else if (Find(FuzzInput::AllFlags, c) >= 0)
    {
      this->Input.Flags += this->Input.Has(c) ? "" : std::string(1, c);
    }
    else if (!pieces.empty())
    {
      FuzzPiece& piece = pieces.back();
      piece.Open |= c == 'o';
      piece.Label = Find(LabelNames, c) >= 0 ? Find(LabelNames, c) : piece.Label;
      piece.Port = Find(PortNames, c) >= 0 ? Find(PortNames, c) : piece.Port;
    }
  }

  int ReadDigits(int maximum)
  {
    const bool isNegative = this->Place < this->Text.size() && this->Text[this->Place] == '-';
    this->Place += isNegative ? 1 : 0;
    int value = 0;
    while (this->Place < this->Text.size() && IsDigit(this->Text[this->Place]))
    {
      value = std::min(maximum, 10 * value + (this->Text[this->Place++] - '0'));
    }
    return isNegative ? -value : value;
  }

  FuzzNumber ReadNumber()
  {
    FuzzNumber number;
    number.Whole = this->ReadDigits(FuzzInput::Greatest);
    while (this->Place < this->Text.size() && Find("meh", this->Text[this->Place]) >= 0)
    {
      const char part = this->Text[this->Place++];
      (part == 'm'      ? number.Middle
          : part == 'e' ? number.Last
                        : number.Height) = this->ReadDigits(9);
    }
    return number;
  }

  /// Gives the numbers to the frame or to the last piece.
  void Finish()
  {
    if (this->Input.Pieces.empty())
    {
      std::copy_n(this->Numbers.begin(), std::min<std::size_t>(6, this->Numbers.size()),
        this->Input.Frame.begin());
    }
    else
    {
      FuzzPiece& piece = this->Input.Pieces.back();
      piece.Plane = this->Numbers.empty() ? FuzzNumber() : this->Numbers[0];
      const std::size_t count = std::min(this->Numbers.size(), 2 * FuzzInput::MaxVertices + 1);
      for (std::size_t i = 2; i < count; i += 2)
      {
        piece.Vertices.push_back({ this->Numbers[i - 1], this->Numbers[i] });
      }
    }
    this->Numbers.clear();
  }

  const std::string& Text;
  std::size_t Place = 0;
  std::vector<FuzzNumber> Numbers;
  FuzzInput Input;
};

std::string Write(const FuzzNumber& number)
{
  const auto part = [](const char* name, int value)
  { return value == 0 ? std::string() : name + std::to_string(value); };
  return std::to_string(number.Whole) + part("m", number.Middle) + part("e", number.Last) +
    part("h", number.Height);
}

std::string Write(const FuzzPiece& piece)
{
  std::string text = Axes[piece.Axis] + Write(piece.Plane);
  text += piece.Open ? "o" : "";
  text += piece.Label < 0 ? std::string() : std::string(1, LabelNames[piece.Label]);
  text += piece.Port < 0 ? std::string() : std::string(1, PortNames[piece.Port]);
  text += ':';
  for (const auto& vertex : piece.Vertices)
  {
    text += ' ' + Write(vertex[0]) + ',' + Write(vertex[1]);
  }
  return text + '\n';
}
}

bool FuzzInput::HasLabels() const
{
  return std::any_of(this->Pieces.begin(), this->Pieces.end(),
    [](const FuzzPiece& piece) { return piece.Label >= 0; });
}

FuzzInput ReadFuzzInput(const std::string& text) { return Reader(text).Run(); }

std::string WriteFuzzInput(const FuzzInput& input)
{
  std::string text = input.Flags;
  std::size_t count = input.Frame.size();
  const auto isZero = [](const FuzzNumber& n) { return n.Value() == 0.0; };
  while (count > 0 && isZero(input.Frame[count - 1]))
  {
    --count;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    text += ' ' + Write(input.Frame[i]);
  }
  text += '\n';
  for (const FuzzPiece& piece : input.Pieces)
  {
    text += Write(piece);
  }
  return text;
}

} // namespace support
} // namespace orthoslices
