// SPDX-License-Identifier: GPL-3.0-or-later
// dialog_test.cpp: MeshLab 2025.07's own parameter dialog: what it shows at first and what is typed there
// arrives.
//
// The first argument is the plugin's file.
#include "documents.h"
#include "loaded_plugin.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QtTest>
#include <common_gui/rich_parameter/richparameterlistdialog.h>

namespace developable::test {

namespace {

/// A mesh so small that the dialog can't show -1 in a length, which it clips to less than minus its diagonal.
TriangleMesh smallPanel(double size) {
	TriangleMesh mesh = jitteredGrid(9, 9, bumpedCylinder);
	mesh.positions *= size;
	return mesh;
}

} // namespace

class DialogTest : public QObject {
	Q_OBJECT

public:
	explicit DialogTest(const QString& file) : plugin_(file) {}

private slots:
	void initTestCase() { QVERIFY2(plugin_.whyNot().isEmpty(), qUtf8Printable(plugin_.whyNot())); }

	void defaultsSurviveTheDialog_data() {
		QTest::addColumn<QString>("filter");
		for (const char* filter : {"Global Developability", "Local Developability", "Developability Maps"})
			QTest::newRow(filter) << filter;
	}
	void defaultsSurviveTheDialog() {
		QFETCH(QString, filter);
		MeshDocument document;
		addLayer(document, smallPanel(10));
		RichParameterList shown = plugin_.parameters(filter, document);
		RichParameterList accepted = shown;
		RichParameterListDialog dialog(nullptr, accepted);
		dialog.getAccept();
		for (const RichParameter& parameter : shown) {
			RichParameter& after = accepted.getParameterByName(parameter.name());
			if (parameter.value().isFloat())
				QVERIFY2(std::abs(after.value().getFloat() - parameter.value().getFloat()) < 1e-7,
						 qUtf8Printable(parameter.name()));
			else if (parameter.value().isInt())
				QCOMPARE(after.value().getInt(), parameter.value().getInt());
			else
				QCOMPARE(after.value().getBool(), parameter.value().getBool());
		}
	}

	void anAutomaticLengthStaysAutomatic_data() {
		QTest::addColumn<double>("size");
		for (const double size : {1e-3, 0.1, 1.0, 1000.0})
			QTest::addRow("%g", size) << size;
	}
	void anAutomaticLengthStaysAutomatic() {
		QFETCH(double, size);
		MeshDocument document;
		addLayer(document, smallPanel(size));
		RichParameterList list = plugin_.parameters("Local Developability", document);
		RichParameterListDialog dialog(nullptr, list);
		dialog.getAccept();
		QVERIFY(list.getAbsPerc("max_displacement") < 0);
		QCOMPARE(list.getAbsPerc("weld_distance"), Scalarm(0));
	}

	void whatIsTypedArrives() {
		MeshDocument document;
		addLayer(document, smallPanel(10));
		RichParameterList list = plugin_.parameters("Local Developability", document);
		RichParameterListDialog dialog(nullptr, list);
		// Lengths have two boxes each, the length and its share of the diagonal; max_displacement is the
		// second.
		const QList<QDoubleSpinBox*> lengths = dialog.findChildren<QDoubleSpinBox*>();
		QCOMPARE(lengths.size(), 4);
		type(lengths[2], "0.25");
		const QList<QComboBox*> choices = dialog.findChildren<QComboBox*>();
		choices.last()->setCurrentText("Displacement");
		dialog.getAccept();
		QCOMPARE(list.getAbsPerc("max_displacement"), Scalarm(0.25));
		QCOMPARE(list.getEnum("map"), 6);

		const Outcome outcome = plugin_.apply("Local Developability", document, list, nullptr);
		QVERIFY2(outcome.succeeded, qUtf8Printable(outcome.error));
		QCOMPARE(outcome.log.filter(QRegularExpression("^vertex quality: Displacement")).size(), 1);
		const QString largest =
			outcome.log.filter(QRegularExpression("^max_displacement: ")).value(0).section(' ', 1);
		QVERIFY(largest.toDouble() > 0.2 && largest.toDouble() < 0.25 + 1e-9);
	}

	void whatIsTypedArrivesWhateverItsType() {
		MeshDocument document;
		addLayer(document, smallPanel(10));
		RichParameterList list = plugin_.parameters("Global Developability", document);
		RichParameterListDialog dialog(nullptr, list);
		QList<QLineEdit*> lines; // of numbers that are no lengths: boxes have lines of their own inside
		for (QLineEdit* line : dialog.findChildren<QLineEdit*>())
			if (qobject_cast<QAbstractSpinBox*>(line->parentWidget()) == nullptr)
				lines.push_back(line);
		QCOMPARE(lines.size(), 8);
		type(lines[0], "0.02"); // angle_tolerance
		type(lines[2], "7");    // max_iterations
		const QList<QCheckBox*> switches = dialog.findChildren<QCheckBox*>();
		QCOMPARE(switches.size(), 4);
		switches[1]->click(); // fix_boundary
		dialog.findChildren<QComboBox*>().first()->setCurrentText("Conjugate gradient");
		dialog.getAccept();
		QCOMPARE(float(list.getFloat("angle_tolerance")), 0.02f); // the dialog reads single precision
		QCOMPARE(list.getInt("max_iterations"), 7);
		QVERIFY(list.getBool("fix_boundary") && !list.getBool("fix_selected"));
		QCOMPARE(list.getEnum("solver"), 1);
	}

	void theChosenLayerArrives() {
		MeshDocument document;
		const MeshModel& other = addLayer(document, smallPanel(9));
		addLayer(document, smallPanel(10));
		RichParameterList list = plugin_.parameters("Developability Maps", document);
		RichParameterListDialog dialog(nullptr, list);
		const QList<QComboBox*> choices = dialog.findChildren<QComboBox*>(); // patches, map, reference
		QCOMPARE(choices.size(), 3);
		QCOMPARE(choices[2]->count(), 2);
		choices[2]->setCurrentIndex(1 - choices[2]->currentIndex());
		dialog.getAccept();
		QCOMPARE(list.getMeshId("reference"), other.id());
	}

private:
	static void type(QLineEdit* line, const QString& text) {
		line->selectAll();
		QTest::keyClicks(line, text);
		QTest::keyClick(line, Qt::Key_Return);
	}

	static void type(QDoubleSpinBox* box, const QString& text) {
		box->selectAll();
		QTest::keyClicks(box, text);
		QTest::keyClick(box, Qt::Key_Return);
	}

	LoadedPlugin plugin_;
};

} // namespace developable::test

int main(int argumentCount, char** arguments) {
	QApplication application(argumentCount, arguments);
	developable::test::DialogTest test(QString::fromLocal8Bit(arguments[1]));
	return QTest::qExec(&test, argumentCount - 1, arguments + 1);
}

#include "dialog_test.moc"
