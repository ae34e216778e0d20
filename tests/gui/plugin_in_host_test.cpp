// SPDX-License-Identifier: GPL-3.0-or-later
// plugin_in_host_test.cpp: what scripts can't show of the plugin in its host: progress, stops, errors on the
// mesh.
//
// The first argument is the plugin's file.
#include "documents.h"
#include "loaded_plugin.h"

#include <QElapsedTimer>
#include <QtTest>

namespace developable::test {

namespace {

const QString globalFilter = "Global Developability", localFilter = "Local Developability",
			  mapsFilter = "Developability Maps", restoreFilter = "Restore Original Shape";

/// What the host's callback saw; it is a plain function, so this can't be anywhere else.
struct CallbackRecord {
	int calls = 0;
	int stopAtCall = 0; ///< 0: never
	QString stopAtWord; ///< empty: never
	std::vector<int> percents;
	QStringList messages;
};
CallbackRecord record;

bool recordingCallback(const int percent, const char* message) {
	++record.calls;
	record.percents.push_back(percent);
	record.messages.push_back(QString::fromUtf8(message));
	const bool hasWord = !record.stopAtWord.isEmpty() && record.messages.back().contains(record.stopAtWord);
	return record.calls != record.stopAtCall && !hasWord;
}

/// Something that takes both methods a while: they are asked for more than can be had.
RichParameterList endlessParameters(LoadedPlugin& plugin, const QString& filter, MeshDocument& document) {
	RichParameterList list = plugin.parameters(filter, document);
	list.setValue("angle_tolerance", FloatValue(0));
	if (filter == globalFilter) {
		list.setValue("solver", EnumerationValue(1));
		list.setValue("relative_change", FloatValue(0));
		list.setValue("max_iterations", IntValue(1000000));
	} else {
		list.setValue("max_operations", IntValue(2000000000));
	}
	return list;
}

QString statusOf(const Outcome& outcome) {
	return outcome.log.filter(QRegularExpression("^status: ")).value(0);
}

} // namespace

class PluginInHostTest : public QObject {
	Q_OBJECT

public:
	explicit PluginInHostTest(const QString& file) : plugin_(file) {}

private slots:
	void initTestCase() { QVERIFY2(plugin_.whyNot().isEmpty(), qUtf8Printable(plugin_.whyNot())); }

	void noPreviewThatTheHostCouldNotCancel() {
		// Its undo leaves custom attributes and new layers, and every filter but one makes some of these.
		const QStringList filters = plugin_.filters();
		QVERIFY(filters.size() >= 4);
		for (const QString& filter : filters)
			QVERIFY2(!plugin_.hasPreview(filter), qUtf8Printable(filter));
	}

	void init() { record = CallbackRecord(); }

	void aStopLeavesTheLayerAsItWas_data() { bothFiltersAndTwoStops(); }
	void aStopLeavesTheLayerAsItWas() {
		QFETCH(QString, filter);
		QFETCH(int, stopAtCall);
		MeshDocument document;
		MeshModel& layer = addLayer(document, jitteredGrid(200, 200, bumpedCylinder));
		const LayerState before(layer);
		record.stopAtCall = stopAtCall;
		const Outcome outcome =
			plugin_.apply(filter, document, endlessParameters(plugin_, filter, document), recordingCallback);
		QVERIFY2(outcome.succeeded, qUtf8Printable(outcome.error));
		QVERIFY2(statusOf(outcome).startsWith("status: stopped by the user"),
				 qUtf8Printable(outcome.log.join('\n')));
		QVERIFY(outcome.log.contains("max_displacement: 0"));
		QCOMPARE(record.calls, stopAtCall);
		QVERIFY(LayerState(layer) == before);
	}

	void aStopWhileAMapIsMadeLeavesTheLayerAsItWas() {
		MeshDocument document;
		MeshModel& layer = addLayer(document, jitteredGrid(100, 100, bumpedCylinder));
		const LayerState before(layer);
		RichParameterList list = plugin_.parameters(mapsFilter, document);
		list.setValue("map", EnumerationValue(7)); // Elastic energy, for which the patches are laid flat
		record.stopAtCall = 1;
		const Outcome outcome = plugin_.apply(mapsFilter, document, list, recordingCallback);
		QVERIFY2(outcome.succeeded, qUtf8Printable(outcome.error));
		QVERIFY2(outcome.log.contains("stopped by the user: nothing was changed"),
				 qUtf8Printable(outcome.log.join('\n')));
		QCOMPARE(record.calls, 1);
		QVERIFY(LayerState(layer) == before);
	}

	void progressIsToldAtMostTwentyTimesASecond() {
		MeshDocument document;
		addLayer(document, jitteredGrid(40, 40, bumpedCylinder));
		record.stopAtCall = 6;
		QElapsedTimer timer;
		timer.start();
		plugin_.apply(globalFilter, document, endlessParameters(plugin_, globalFilter, document),
					  recordingCallback);
		QCOMPARE(record.calls, 6);
		QVERIFY(timer.elapsed() >= 5 * 50);
		QVERIFY(std::is_sorted(record.percents.begin(), record.percents.end()));
		QVERIFY(record.percents.front() >= 0 && record.percents.back() <= 100);
	}

	void progressSaysHowMuchOfGIsGoneAndHowLongTheRestTakes() {
		MeshDocument document;
		addLayer(document, jitteredGrid(200, 200, bumpedCylinder));
		record.stopAtWord = "left at this pace";
		plugin_.apply(globalFilter, document, endlessParameters(plugin_, globalFilter, document),
					  recordingCallback);
		const QRegularExpression both("[0-9.]+ % of the detect function removed; .+ left at this pace$");
		QVERIFY2(record.messages.back().contains(both), qUtf8Printable(record.messages.back()));
		QVERIFY(!record.messages.front().contains("left")); // there is no pace yet
	}

	void aHostWithoutCallbackIsServedToo() {
		MeshDocument document;
		MeshModel& layer = addLayer(document, jitteredGrid(9, 9, bumpedCylinder));
		const LayerState before(layer);
		QVERIFY(plugin_.apply(globalFilter, document, plugin_.parameters(globalFilter, document), nullptr)
					.succeeded);
		QVERIFY(!(LayerState(layer) == before));
	}

	void aSuccessWritesWhatItSays() {
		MeshDocument document;
		MeshModel& layer = addLayer(document, jitteredGrid(9, 9, bumpedCylinder));
		QVERIFY(!layer.hasDataMask(MeshModel::MM_VERTCOLOR));
		QVERIFY(plugin_.apply(localFilter, document, plugin_.parameters(localFilter, document), nullptr)
					.succeeded);
		QVERIFY(layer.hasDataMask(MeshModel::MM_VERTCOLOR | MeshModel::MM_VERTQUALITY));
		QCOMPARE(LayerState(layer).attributes,
				 (std::vector<std::string>{"displacement", "original_position"}));
	}

	void theWayBackGoesBackToTheLastBit() {
		MeshDocument document;
		MeshModel& layer = addLayer(document, jitteredGrid(9, 9, bumpedCylinder));
		const std::vector<CMeshO::CoordType> before = pointsOf(layer);
		for (const QString& filter : {globalFilter, localFilter}) {
			const Outcome there =
				plugin_.apply(filter, document, plugin_.parameters(filter, document), nullptr);
			QVERIFY(!there.log.filter(QRegularExpression("^way back: .*" + restoreFilter)).isEmpty());
			QVERIFY(pointsOf(layer) != before);
			QVERIFY(plugin_.parameters(restoreFilter, document).isEmpty());
			QVERIFY(plugin_.apply(restoreFilter, document, RichParameterList(), nullptr).succeeded);
			QVERIFY(pointsOf(layer) == before);
		}
		expectRefusal(restoreFilter, jitteredGrid(9, 9, bumpedCylinder), "'original_position'");
	}

	void errorsAreSaidAndLeaveTheLayerAsItWas_data() { allFilters(); }
	void errorsAreSaidAndLeaveTheLayerAsItWas() {
		QFETCH(QString, filter);
		TriangleMesh spoilt = jitteredGrid(9, 9, bumpedCylinder);
		spoilt.positions.col(40).setConstant(std::numeric_limits<double>::infinity());
		expectRefusal(filter, spoilt, "1 vertex has a coordinate that is infinite or not a number");
		TriangleMesh flat = jitteredGrid(9, 9, bumpedCylinder);
		flat.positions.col(flat.triangles(0, 5)) = flat.positions.col(flat.triangles(1, 5));
		expectRefusal(filter, flat, "no area");
		if (filter != mapsFilter)
			expectRefusal(filter, sphere(1, 2), "1 of 1 patch is closed");
		TriangleMesh cloud = jitteredGrid(9, 9, bumpedCylinder);
		cloud.triangles.resize(3, 0);
		expectRefusal(filter, cloud, "no faces");
	}

	void aDocumentWithoutLayersIsRefused_data() { allFilters(); }
	void aDocumentWithoutLayersIsRefused() {
		QFETCH(QString, filter);
		MeshDocument document;
		const Outcome outcome =
			plugin_.apply(filter, document, plugin_.parameters(filter, document), nullptr);
		QVERIFY(!outcome.succeeded);
		QCOMPARE(outcome.error, QString("There is no mesh: open one first."));
	}

private:
	static std::vector<CMeshO::CoordType> pointsOf(const MeshModel& layer) {
		std::vector<CMeshO::CoordType> points;
		for (const CVertexO& vertex : layer.cm.vert)
			points.push_back(vertex.cP());
		return points;
	}

	static void allFilters() {
		QTest::addColumn<QString>("filter");
		for (const QString& filter : {globalFilter, localFilter, mapsFilter})
			QTest::newRow(qUtf8Printable(filter)) << filter;
	}

	static void bothFiltersAndTwoStops() {
		QTest::addColumn<QString>("filter");
		QTest::addColumn<int>("stopAtCall");
		for (const QString& filter : {globalFilter, localFilter})
			for (const int call : {1, 2})
				QTest::addRow("%s, call %d", qUtf8Printable(filter), call) << filter << call;
	}

	void expectRefusal(const QString& filter, const TriangleMesh& mesh, const QString& sentence) {
		MeshDocument document;
		MeshModel& layer = addLayer(document, mesh);
		const LayerState before(layer);
		const Outcome outcome =
			plugin_.apply(filter, document, plugin_.parameters(filter, document), nullptr);
		QVERIFY(!outcome.succeeded);
		QVERIFY2(outcome.error.contains(sentence), qUtf8Printable(outcome.error));
#if DEVELOPABLE_HOST_YEAR == 2020
		QVERIFY2(outcome.log.contains(outcome.error), "meshlabserver prints the log only");
#endif
		QVERIFY(LayerState(layer) == before);
	}

	LoadedPlugin plugin_;
};

} // namespace developable::test

int main(int argumentCount, char** arguments) {
	QApplication application(argumentCount, arguments);
	developable::test::PluginInHostTest test(QString::fromLocal8Bit(arguments[1]));
	return QTest::qExec(&test, argumentCount - 1, arguments + 1);
}

#include "plugin_in_host_test.moc"
