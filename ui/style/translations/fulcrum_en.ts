<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<TS version="2.1" language="en_GB" sourcelanguage="en">
<context>
    <name>fulcrum::ui::AttemptsPage</name>
    <message numerus="yes">
        <source>%n scores were computed with older metrics or limits. Recomputing adds a second score to each attempt; the score in force does not change.</source>
        <translation>
            <numerusform>%n score was computed with older metrics or limits. Recomputing adds a second score to the attempt; the score in force does not change.</numerusform>
            <numerusform>%n scores were computed with older metrics or limits. Recomputing adds a second score to each attempt; the score in force does not change.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>and of %n more people</source>
        <translation>
            <numerusform>and of %n more person</numerusform>
            <numerusform>and of %n more people</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempts</source>
        <translation>
            <numerusform>%n attempt</numerusform>
            <numerusform>%n attempts</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::AuditPage</name>
    <message numerus="yes">
        <source>%n entries shown</source>
        <translation>
            <numerusform>%n entry shown</numerusform>
            <numerusform>%n entries shown</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::ChartFrame</name>
    <message numerus="yes">
        <source>%n rows were copied.</source>
        <translation>
            <numerusform>%n row was copied.</numerusform>
            <numerusform>%n rows were copied.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::CohortPage</name>
    <message numerus="yes">
        <source>%n people</source>
        <translation>
            <numerusform>%n person</numerusform>
            <numerusform>%n people</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::ComparisonTexts</name>
    <message numerus="yes">
        <source>Aligned by the %n steps that were completed in both.</source>
        <translation>
            <numerusform>Aligned by the %n step that was completed in both.</numerusform>
            <numerusform>Aligned by the %n steps that were completed in both.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n other people have completed this task with this variant and class of device. A band needs at least 5.</source>
        <translation>
            <numerusform>%1: %n other person has completed this task with this variant and class of device. A band needs at least 5.</numerusform>
            <numerusform>%1: %n other people have completed this task with this variant and class of device. A band needs at least 5.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: the latest counting attempt of %n other people. Line: median; band: the middle half.</source>
        <translation>
            <numerusform>%1: the latest counting attempt of %n other person. Line: median; band: the middle half.</numerusform>
            <numerusform>%1: the latest counting attempt of %n other people. Line: median; band: the middle half.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The recording of %n of them was not kept here: only their metrics are compared.</source>
        <translation>
            <numerusform>The recording of %n of them was not kept here: only the metrics are compared.</numerusform>
            <numerusform>The recording of %n of them was not kept here: only their metrics are compared.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::CurriculumPage</name>
    <message numerus="yes">
        <source>passes on %n variants</source>
        <translation>
            <numerusform>passes on %n variant</numerusform>
            <numerusform>passes on %n variants</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n ratings with the form %1, mean at least %2</source>
        <translation>
            <numerusform>%n rating with the form %1, mean at least %2</numerusform>
            <numerusform>%n ratings with the form %1, mean at least %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>✕ %n problems</source>
        <translation>
            <numerusform>✕ %n problem</numerusform>
            <numerusform>✕ %n problems</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::DashboardPage</name>
    <message numerus="yes">
        <source>%n people</source>
        <translation>
            <numerusform>%n person</numerusform>
            <numerusform>%n people</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::DashboardTexts</name>
    <message numerus="yes">
        <source>%n people</source>
        <translation>
            <numerusform>%n person</numerusform>
            <numerusform>%n people</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>plan: all tasks in %n weeks</source>
        <translation>
            <numerusform>plan: all tasks in %n week</numerusform>
            <numerusform>plan: all tasks in %n weeks</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n have not begun</source>
        <translation>
            <numerusform>%n has not begun</numerusform>
            <numerusform>%n have not begun</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n people who tried are not there yet</source>
        <translation>
            <numerusform>%1: %n person who tried is not there yet</numerusform>
            <numerusform>%1: %n people who tried are not there yet</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>week of %1: %n attempts</source>
        <translation>
            <numerusform>week of %1: %n attempt</numerusform>
            <numerusform>week of %1: %n attempts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempts</source>
        <translation>
            <numerusform>%n attempt</numerusform>
            <numerusform>%n attempts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n checks</source>
        <translation>
            <numerusform>%n check</numerusform>
            <numerusform>%n checks</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::DebriefPage</name>
    <message numerus="yes">
        <source>An educator struck %n errors that the program had recorded. The score stays as it is: scores are never edited. An educator can void the attempt, or decide on the standing.</source>
        <translation>
            <numerusform>An educator struck %n error that the program had recorded. The score stays as it is: scores are never edited. An educator can void the attempt, or decide on the standing.</numerusform>
            <numerusform>An educator struck %n errors that the program had recorded. The score stays as it is: scores are never edited. An educator can void the attempt, or decide on the standing.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::HomePage</name>
    <message numerus="yes">
        <source>%n do not count</source>
        <translation>
            <numerusform>%n does not count</numerusform>
            <numerusform>%n do not count</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::ImportCard</name>
    <message numerus="yes">
        <source>%n new accounts</source>
        <translation>
            <numerusform>%n new account</numerusform>
            <numerusform>%n new accounts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n people get a role</source>
        <translation>
            <numerusform>%n person gets a role</numerusform>
            <numerusform>%n people get a role</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n are there already</source>
        <translation>
            <numerusform>%n is there already</numerusform>
            <numerusform>%n are there already</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n left out</source>
        <translation>
            <numerusform>%n left out</numerusform>
            <numerusform>%n left out</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n accounts were made.</source>
        <translation>
            <numerusform>%n account was made.</numerusform>
            <numerusform>%n accounts were made.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::PassRuleDesigner</name>
    <message numerus="yes">
        <source>%n passes in a row</source>
        <translation>
            <numerusform>%n pass</numerusform>
            <numerusform>%n passes in a row</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::PersonalDataPage</name>
    <message numerus="yes">
        <source>Erase %n people for good</source>
        <translation>
            <numerusform>Erase %n person for good</numerusform>
            <numerusform>Erase %n people for good</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n people are due.</source>
        <translation>
            <numerusform>%n person is due.</numerusform>
            <numerusform>%n people are due.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n people were erased.</source>
        <translation>
            <numerusform>%n person was erased.</numerusform>
            <numerusform>%n people were erased.</numerusform>
        </translation>
    </message>
</context>
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
<context>
    <name>fulcrum::ui::RepairPage</name>
    <message numerus="yes">
        <source>%n people</source>
        <translation>
            <numerusform>%n person</numerusform>
            <numerusform>%n people</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempts</source>
        <translation>
            <numerusform>%n attempt</numerusform>
            <numerusform>%n attempts</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::SchedulesPage</name>
    <message numerus="yes">
        <source>%n files written.</source>
        <translation>
            <numerusform>%n file written.</numerusform>
            <numerusform>%n files written.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::ServerCard</name>
    <message numerus="yes">
        <source>%n person(s) were erased here, as on the server.</source>
        <translation>
            <numerusform>%n person was erased here, as on the server.</numerusform>
            <numerusform>%n people were erased here, as on the server.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::SignInPage</name>
    <message numerus="yes">
        <source>Educators and the director see %n more trainee(s).</source>
        <translation>
            <numerusform>Educators and the director see %n more trainee.</numerusform>
            <numerusform>Educators and the director see %n more trainees.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempts were running when the program last ended. They are listed as interrupted; everything recorded until then is kept.</source>
        <translation>
            <numerusform>%n attempt was running when the program last ended. It is listed as interrupted; everything recorded until then is kept.</numerusform>
            <numerusform>%n attempts were running when the program last ended. They are listed as interrupted; everything recorded until then is kept.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::StationPage</name>
    <message numerus="yes">
        <source>%n attempts were simulated again; all agree with their records.</source>
        <translation>
            <numerusform>%n attempt was simulated again; it agrees with its record.</numerusform>
            <numerusform>%n attempts were simulated again; all agree with their records.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::TaskNeedsForm</name>
    <message numerus="yes">
        <source>Installed: %n variants</source>
        <translation>
            <numerusform>Installed: %n variant</numerusform>
            <numerusform>Installed: %n variants</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::ToRatePage</name>
    <message numerus="yes">
        <source>%n attempts</source>
        <translation>
            <numerusform>%n attempt</numerusform>
            <numerusform>%n attempts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempts, %1 awaiting rating</source>
        <translation>
            <numerusform>%n attempt, %1 awaiting rating</numerusform>
            <numerusform>%n attempts, %1 awaiting rating</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::TraceImportCard</name>
    <message numerus="yes">
        <source>%n samples</source>
        <translation>
            <numerusform>%n sample</numerusform>
            <numerusform>%n samples</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n metrics have a value</source>
        <translation>
            <numerusform>%n metric has a value</numerusform>
            <numerusform>%n metrics have a value</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n samples without a value were left out.</source>
        <translation>
            <numerusform>%n sample without a value was left out.</numerusform>
            <numerusform>%n samples without a value were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stretches of more than 0.1 s have no sample; nothing is measured across them.</source>
        <translation>
            <numerusform>%n stretch of more than 0.1 s has no sample; nothing is measured across it.</numerusform>
            <numerusform>%n stretches of more than 0.1 s have no sample; nothing is measured across them.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::goals</name>
    <message numerus="yes">
        <source>%n days left.</source>
        <translation>
            <numerusform>%n day left.</numerusform>
            <numerusform>%n days left.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempts a week</source>
        <translation>
            <numerusform>%n attempt a week</numerusform>
            <numerusform>%n attempts a week</numerusform>
        </translation>
    </message>
</context>
</TS>
