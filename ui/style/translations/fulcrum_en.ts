<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<TS version="2.1" language="en_GB" sourcelanguage="en">
<context>
    <name>fulcrum::ui::PracticeView</name>
    <message numerus="yes">
        <source>%1, week of %2: %n attempts</source>
        <translation>
            <numerusform>%1, week of %2: %n attempt</numerusform>
            <numerusform>%1, week of %2: %n attempts</numerusform>
        </translation>
    </message>
</context>
</TS>
